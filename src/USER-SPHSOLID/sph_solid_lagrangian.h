/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   Copyright (2003) Sandia Corporation.  Under the terms of Contract
   DE-AC04-94AL85000 with Sandia Corporation, the U.S. Government retains
   certain rights in this software.  This software is distributed under
   the GNU General Public License.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

/* ----------------------------------------------------------------------
   The sweeps of the Lagrangian frame: pairs and kernel gradients belong to the
   reference configuration and are never renewed; see sph_solid_sweeps.h.

   The class; its members are in
     sph_solid_lagrangian_partners.h    what is constant between two neighbor lists
     sph_solid_lagrangian_limits.h      the time step, and where the frame ends
     sph_solid_lagrangian_rows.h        what neighbors read: messages, mirror images
     sph_solid_lagrangian_viscous.h     switch of a viscosity, acceleration correction
     sph_solid_lagrangian_heat.h        heat, virial
     sph_solid_lagrangian_elastic.h     small vibrations about the reference
     sph_solid_lagrangian_sweeps.h      gradient and force

   Every lane has a particle of its own: a block has as many particles as there are lanes,
   side by side in columns (sph_solid_columns.h), and their pairs come in slots
   (sph_solid_slots.h), of which those that are alike share what is constant (sph_solid_shared.h).

   With X reference positions, V0 reference volumes, g_ij = grad_i W(X_i - X_j):

     M_i  = sum_j V0_j (X_j - X_i) (x) g_ij,  B_i = M_i^-1
     F_i  = 1 + [sum_j V0_j (u_j - u_i) (x) g_ij] B_i,  u = x - X
     F'_i = [sum_j V0_j (v_j - v_i) (x) g_ij] B_i
     L_i  = F'_i (F_i - dt/2 F'_i)^-1            in the middle of the step
     D_i  = sym(F'_i F_i^-1)                     rate of deformation
     C_i  = J_i F_i^-T B_i^T,  J_i = m_i/(rho_i V0_i)
     f_ij = V0_i V0_j (sigma_i C_i + sigma_j C_j) g_ij

   B makes F exact for linear fields, and the same B in C makes f_ij the exact
   adjoint of F.  Linear momentum is exact since f_ij = -f_ji; angular momentum
   since sum_j V0_j (x_j - x_i) (x) C_i g_ij = J_i 1 and sigma is symmetric.
   Corrected total-Lagrangian SPH: Bonet & Kulasegaram (2002); Ganzenmueller (2015); doc/theory.rst has
   the derivation and the references.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LAGRANGIAN_H
#define LMP_SPH_SOLID_LAGRANGIAN_H

#include "sph_solid_column_rows.h"
#include "sph_solid_column_views.h"
#include "sph_solid_slots.h"

#include <mutex>

// of one source file, sph_solid_sweeps_lagrangian*.cpp.  That the compiler knows this is worth 5 %
// of a step in two dimensions: it inlines what is called once

namespace {

template <int D, class Precision> class LagrangianSweeps : public ColumnSweeps<D, Precision> {
 public:
  LagrangianSweeps(const Options &o, const std::vector<TypeData> &t) :
      ColumnSweeps<D, Precision>(o, t), at_da(at_rate + (keeps_rates() ? SYMMETRIC : 0)),
      at_rho(at_da + (needs_correction() ? D : 0)),
      damping_unit(Base::largest(t, [](const TypeData &type) {
        return type.material.longitudinal_modulus();
      }))
  {
  }

  void new_neighbors(const Particles &, const NeighborRows &, double) override;
  void pack_kinematics(const Particles &, const double *const *) override;
  int gradient(const Particles &, const NeighborRows &, double) override;
  void mirror_stress() override;
  void find_switch(const Particles &, const NeighborRows &) override;
  void force(const Particles &, const NeighborRows &) override;
  void correction(const Particles &, const NeighborRows &) override;
  void heat(const Particles &, const NeighborRows &, double time, double *) override;
  bool can_keep_heat() const override;
  void add_due_heat(const Particles &, const NeighborRows &) override;
  void elastic_stress(const Particles &) override;
  void elastic_force(const Particles &p) override;
  double time_step_limit(const Particles &, const NeighborRows &) const override;
  double scaled_time_step_limit(const Particles &, const std::vector<double> &) const override;
  int neighbor_count(int i) const override;
  int uncorrected() const override { return nuncorrected; }
  Overload find_overload() const override;
  Overload find_torn() const override;
  double memory_usage() const override;
  void displace(const double *const *u) override;
  void displace(const Particles &, const Kick &) override;

 private:
  using Base = ColumnSweeps<D, Precision>;
  using Base::asks_ahead, Base::asks_for_block, Base::blocks, Base::column_of, Base::columns,
      Base::component, Base::each_block, Base::end_of_own, Base::image_first, Base::image_j,
      Base::images, Base::keeps_pairs, Base::LANES, Base::load, Base::lonely, Base::mirror_vectors,
      Base::needs_correction, Base::nparticles, Base::nthreads, Base::opt, Base::own,
      Base::particles_of, Base::repeat_last, Base::ruler, Base::safe, Base::source_of,
      Base::standard_power, Base::store_tensor, Base::stretching, Base::SYMMETRIC, Base::tensor,
      Base::types, Base::unit_factor, Base::V, Base::with_rows, Base::X;
  using typename Base::Batch, typename Base::Motion, typename Base::Number, typename Base::Numbers,
      typename Base::Pack, typename Base::Parts, typename Base::Places, typename Base::Sent,
      typename Base::Tensors, typename Base::Totals;

  // components of a column behind positions and velocities: positions in the reference,
  // V0/h0^(D+2); what ghosts are sent, most of it from the constitutive update: sigma C,
  // hourglass/2 rho c_L h/damping_unit, bulk sound speed, density that viscosity sees, n of the
  // correction or the switch of a viscosity; then, if a scene needs them, the rate of deformation,
  // the viscous acceleration and, where materials are unlike, the density in the reference
  static constexpr int REFERENCE = 2 * D, WEIGHT = 3 * D, T = WEIGHT + 1, IMPEDANCE = T + D * D,
                       SOUND = IMPEDANCE + 1, DENSITY = SOUND + 1, LAST = DENSITY + 1,
                       FIXED = LAST + 1;
  bool keeps_rates() const { return opt.hourglass > 0.0 || needs_rates(pair_form(opt.viscosity)); }
  static constexpr int at_rate = FIXED;
  const int at_da;
  const int at_rho;
  int components() const { return at_rho + (this->unlike ? 1 : 0); }
  Sent sent() const override { return {T, LAST, at_da}; }

  // what an evaluation leaves of own particles for heat, side by side: sweeps follow one stream.  Components of a
  // block: the viscous force that heats, before the correction all that waits for it; the hourglass
  // force; powers of stress and of pairs (sph_solid_lagrangian_heat.h)
  struct Accounts {
    static constexpr int VISCOUS = 0;
    int hourglass = 0, stress = 0, pairs = 0, size = 0;
    Numbers numbers;
    std::size_t place(int block, int component) const
    {
      return (block * std::size_t(size) + component) * LANES;
    }
    Number *at(int block, int component) { return &numbers[place(block, component)]; }
    const Number *at(int block, int component) const { return &numbers[place(block, component)]; }
  };
  Accounts accounts;
  void size_accounts();

  using Slots = SlotsOf<LANES>;
  Slots slots;
  // of own particles: B on and above the diagonal, sum V0_j g_ij
  Numbers B, gradient_sum;
  // of own: viscous force that no correction touches, in scenes that have both; power of forces on the
  // velocities they come from, before displacements take their place
  Numbers heated_force, power_then;
  bool velocities_known = false;    // are they still in their place?
  const double damping_unit;        // [pressure] the largest modulus of all materials
  Numbers
      central_virial;    // of own: what central forces add to a virial, on and above the diagonal
  // of slots with nearest partners: m_j Wbar_ij, once n is known the weights; with weights safe
  // the force on i is m_i/2 near_pull x_ij, and pulls, which are not shared, are in order 0, 1, ...
  using NearWeights = SharedVectors<Number, LANES>;
  NearWeights near_weight;
  Numbers near_pull;
  std::vector<int> near_in_order;
  Numbers mu_max;    // of own: largest approach rate
  Totals early_totals;
  bool weights_known = false;
  int nuncorrected = 0;    // particles with partners and B = 1
  std::mutex mutex;        // of shared vectors, and of that number

  // what is constant between two neighbor lists
  void place_columns(const Particles &, const NeighborRows &, const std::vector<double> &reference,
                     int side);
  // orders of columns: by ID, or in rows along x, y or z
  static constexpr int BY_ID = -1;
  static int longest_side(const NeighborRows &, const std::vector<double> &reference);
  std::vector<int> choose_order(const Particles &, const NeighborRows &,
                                const std::vector<double> &reference);
  std::vector<int> count_slots(const Particles &, const NeighborRows &,
                               const std::vector<double> &reference, int side);
  std::vector<double> place_references(const Particles &, const NeighborRows &) const;
  void unwrap_references(const Particles &, const NeighborRows &, std::vector<double> &) const;
  void size_storage(int gathered);
  struct Arranging;
  template <class Call> void each_arranging(const Arranging &, Call);

  // a sweep's view of them, by number of slot.  Of gathered ones there are components up to end and, if
  // it is given, from second on: what the sweep stores of other blocks is not among them
  using View = typename Base::template SlotColumns<FIXED + SYMMETRIC + D + 1>;
  class Neighbors : private View {
   public:
    Neighbors(const LagrangianSweeps &s, int block, int end) :
        Neighbors(s, block, end, s.components())
    {
    }
    Neighbors(const LagrangianSweeps &s, int block, int end, int second) :
        View(s, s.slots.gathered, block, 0, end, second, s.components()),
        further(s.slots.further.data()), foremost(s.slots.foremost.data()),
        skipped(s.columns.skipped())
    {
    }
    [[gnu::always_inline]] const Number *operator()(int slot)
    {
      return View::operator()(further[slot]);
    }
    int column(int slot, int lane) const { return View::column(further[slot], lane); }
    // ask for components [0, END), or for two vectors, that a block so many BLOCKS further on will read where
    // this slot reads them
    template <int BLOCKS, int END> void prefetch_ahead(int slot, const Number *j) const
    {
      if (foremost[slot])
        Base::prefetch_components(ahead<BLOCKS>(slot, j), std::make_integer_sequence<int, END>());
    }
    template <int BLOCKS>
    void prefetch_vectors_ahead(int slot, const Number *j, int first, int second) const
    {
      if (!foremost[slot]) return;
      const Number *at = ahead<BLOCKS>(slot, j);
      Base::prefetch_components(at, first, first + D);
      Base::prefetch_components(at, second, second + D);
    }

   private:
    template <int BLOCKS> const Number *ahead(int slot, const Number *j) const
    {
      return j + BLOCKS * LANES + (foremost[slot] > BLOCKS * LANES ? 0 : skipped);
    }
    const int *const further;
    const unsigned char *const foremost;
    const std::ptrdiff_t skipped;
  };
  // V0_j grad_i W = this times X_ij; of the constants of a slot
  static Pack factor(const float *constants, const Number *j)
  {
    return Precision::load(constants + Slots::FACTOR) * component(j, WEIGHT);
  }
  // of a pair u_i - u_j, what x_ij differs from X_ij, and -V0_j g_ij
  [[gnu::always_inline]] void displacement(const Number *i, const Number *j, const Pack *x,
                                           Pack minus_F, Pack *u, Pack *g) const
  {
    Places(*this, i, REFERENCE).apart(j, REFERENCE, g);
    for (int a = 0; a < D; a++) {
      u[a] = x[a] - g[a];
      g[a] = minus_F * g[a];
    }
  }
  Pack own_volume(int block) const    // V0
  {
    return (1.0 / unit_factor) * component(columns.at(block * LANES), WEIGHT);
  }
  Pack factor(int slot, const Number *j) const { return factor(slots.constants.of(slot), j); }
  // vectors and symmetric tensors of own particles
  static std::size_t vector_at(int block) { return block * std::size_t(D) * LANES; }
  static std::size_t symmetric_at(int block) { return block * std::size_t(SYMMETRIC) * LANES; }
  Number *correction_of(int block) { return &B[symmetric_at(block)]; }
  const Number *correction_of(int block) const { return &B[symmetric_at(block)]; }
  static void store_vector(Number *to, const Pack *v)
  {
    each_index<D>([&](auto a) {
      store(to + a * LANES, v[a]);
    });
  }
  // ask for what sweeps read of the block after the next one: accounts; the lists of its slots.  The processor
  // follows fewer streams than there are, and each to the end of a page
  void ask_for_accounts(int block) const
  {
    prefetch(accounts.numbers.data() + accounts.place(block + 2, 0), accounts.size * LANES);
  }
  void ask_for_slots(int block) const
  {
    const int first = slots.first[block + 2], n = slots.first[block + 3] - first;
    slots.constants.ask(first, n);
    prefetch_list(slots.further.data() + first, n);
    prefetch_list(slots.foremost.data() + first, n);
  }
  void ask_for_force(const Particles &, int block, const Batch &) const;
  Tensors load_correction(int block) const { return load_symmetric(correction_of(block)); }
  // what lies on and above the diagonal
  static void store_symmetric(Number *to, const Tensors &t)
  {
    for (int a = 0; a < D; a++)
      for (int b = a; b < D; b++, to += LANES) store(to, t(a, b));
  }
  static Tensors load_symmetric(const Number *at)
  {
    Tensors t;
    for (int a = 0; a < D; a++)
      for (int b = a; b < D; b++, at += LANES) t(a, b) = t(b, a) = load(at);
    return t;
  }
  struct Sums {
    Tensors displacement, velocity;    // sum V0 (u_j-u_i)(x)g and sum V0 (v_j-v_i)(x)g
  };
  Sums accumulate(int block) const;
  // what the nearest pairs of a block are multiplied by
  typename NearWeights::Run near_factors(int block) const
  {
    const int first = slots.near_first[block];
    if (safe()) return {near_in_order.data() + first, near_pull.data()};
    return near_weight.from(first);
  }
  bool dissipates() const { return opt.hourglass > 0.0 || opt.viscosity != Viscosity::NONE; }
  // pull x (x) x of a pair
  [[gnu::always_inline]] static void add_central(TensorSums<D, Pack> &sum, Pack pull, const Pack *x)
  {
    Pack f[D];
    for (int a = 0; a < D; a++) f[a] = pull * x[a];
    sum.add_symmetric(x, f);
  }
  bool keeps_central() const { return opt.hourglass > 0.0 || keeps_pairs(); }
  Pack power_of(const Number *force, int block) const;
  struct Powers {
    Pack viscous = 0.0, corrected = 0.0, hourglass = 0.0;
    Pack all() const { return viscous + corrected + hourglass; }
  };
  Powers powers_of_forces(int block) const;
  Pack power_of_forces(int block, const Batch &, Pack mass, Totals &) const;
  Pack power_of_stress(int block, const Tensors &displaced) const;
  void save_power();
  Pack uneven_heat(int block, Pack mass) const;
  void enter_due(const Totals &late);
  Tensors block_virial(const Particles &, int block, const Batch &) const override;
  static void repeat_last(Sums &, int n);
  template <bool LATE> int update(const Particles &, int block, const Batch &, double dt, Totals &);
  void add_late_heat(const Particles &, int block, const Batch &, const Tensors &velocity,
                     Totals &) const;

  template <PairForm FORM, bool HOURGLASS> void force_blocks(const Particles &);
  template <PairForm FORM, bool HOURGLASS, bool UNLIKE> void force_each(const Particles &);
  template <PairForm FORM, bool HOURGLASS, bool UNLIKE>
  void force_block(const Particles &, int block, const Batch &, Totals &);

  template <bool HEATS> void correct_block(const Particles &, int block, const Batch &, Totals &);
  void find_weights();
  void safe_pulls(int block);

  Tensors deformation(int block) const;
  double least_limit(const Particles &, const double *factors) const;
  Pack room_left(const Tensors &Fi, int block) const;
  Overload overload(int block) const;
  Overload overload(const Tensor<D> &Fi, int block, int lane) const;
  template <class Find> Overload first_found(Find find) const;
  Overload torn(int block) const;
};

}    // namespace

#endif

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
   The sweeps of the Eulerian frame: neighbors and kernel gradients belong to
   the present positions; see sph_solid_sweeps.h.  Gradients are corrected, and forces their adjoint, as
   Bonet & Lok, Comput. Methods Appl. Mech. Engrg. 180 (1999) 97, have them.

   The class; its members are in
     sph_solid_eulerian_candidates.h    what stays until neighbors are new: who may become a pair
     sph_solid_eulerian_rows.h          what neighbors read: messages, mirror images
     sph_solid_eulerian_viscous.h       switch of a viscosity, acceleration correction
     sph_solid_eulerian_heat.h          heat, virial
     sph_solid_eulerian_sweeps.h        gradient and force

   Every lane has a particle of its own, and candidates come in slots, as the partners of the
   Lagrangian frame do.  In every step the slots are found in which there is a pair: bodies that
   have flowed far are still rows of particles side by side, whose neighbors lie side by side.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_EULERIAN_H
#define LMP_SPH_SOLID_EULERIAN_H

#include "sph_solid_column_rows.h"
#include "sph_solid_column_views.h"
#include "sph_solid_slots.h"

namespace {

// call with a flag as a constant

template <class Call> void with_flag(bool flag, Call call)
{
  if (flag)
    call(std::true_type());
  else
    call(std::false_type());
}

template <int D, class Precision> class EulerianSweeps : public ColumnSweeps<D, Precision> {
 public:
  EulerianSweeps(const Options &o, const std::vector<TypeData> &t) :
      ColumnSweeps<D, Precision>(o, t), uniform(are_alike(t)),
      at_rate(FIXED + (o.tensile ? D * D : 0)),
      at_da(at_rate + (needs_rates(pair_form(o.viscosity)) ? SYMMETRIC : 0)),
      at_h(at_da + (needs_correction() ? D : 0)), at_near(at_h + 1),
      common_h(Base::largest(t, &TypeData::h)),
      common_near(o.hbar * Base::largest(t, &TypeData::spacing))
  {
  }

  void new_neighbors(const Particles &, const NeighborRows &, double) override;
  void pack_kinematics(const Particles &, const double *const *) override;
  int gradient(const Particles &, const NeighborRows &, double) override;
  void unpack(Message, const Particles &, int, const double *) override;
  void mirror_stress() override;
  void find_switch(const Particles &, const NeighborRows &) override;
  void force(const Particles &, const NeighborRows &) override;
  void correction(const Particles &, const NeighborRows &) override;
  void heat(const Particles &, const NeighborRows &, double time, double *) override;
  double time_step_limit(const Particles &, const NeighborRows &) const override;
  int neighbor_count(int i) const override;
  int uncorrected() const override { return nuncorrected; }
  double memory_usage() const override;

 private:
  using Base = ColumnSweeps<D, Precision>;
  using typename Base::Batch, typename Base::Motion, typename Base::Number, typename Base::Numbers,
      typename Base::Pack, typename Base::Parts, typename Base::Place, typename Base::Sent,
      typename Base::Single, typename Base::Tensors, typename Base::Totals;
  using Bits = typename Precision::Bits;
  using Base::asks_ahead, Base::asks_for_block, Base::blocks, Base::column_of, Base::columns,
      Base::component, Base::each_block, Base::end_of_columns, Base::end_of_own, Base::image_first,
      Base::image_j, Base::images, Base::keeps_pairs, Base::LANES, Base::load, Base::lonely,
      Base::needs_correction, Base::nparticles, Base::nthreads, Base::opt, Base::own,
      Base::particles_of, Base::safe, Base::source_of, Base::SYMMETRIC, Base::tensor, Base::types,
      Base::unit_factor, Base::V, Base::X;

  // components of a column behind positions and velocities: V/h0^(D+2), this step's; mass; what
  // ghosts are sent, from the constitutive update: T and K, where the force on i from j is
  // K_i K_j (T_i + T_j) grad W (gradient corrected: K = V, T = sigma B^T; plain: K = m,
  // T = sigma/rho^2, eq. 19), density, bulk sound speed, 1/n of the correction (0: no nearest
  // neighbor) or the switch of a viscosity; then, if a scene needs them, R of the artificial stress, the rate of deformation,
  // the viscous acceleration and, where they differ, smoothing length and support of Wbar
  static constexpr int VOLUME = 2 * D, MASS = VOLUME + 1, T = MASS + 1, K = T + D * D, RHO = K + 1,
                       SOUND = RHO + 1, LAST = SOUND + 1, FIXED = LAST + 1;
  const bool uniform;    // is there one smoothing length, and one spacing?
  static constexpr int at_tension = FIXED;
  const int at_rate, at_da, at_h, at_near;
  int components() const { return at_h + (uniform ? 0 : 2); }
  const double common_h, common_near;    // if there is one

  // slots of candidates, until neighbors are new
  struct Candidates {
    std::vector<int> first{0};     // of each block, and one behind the last
    std::vector<int> further;      // see GATHERED
    std::vector<Bits> lanes;       // which lanes have one
    std::vector<char> mirrored;    // is an image among them?
    std::vector<int> gathered;     // LANES columns each
    std::size_t count = 0;
    void append(const Candidates &);
  } candidates;
  // of rows: sums over pairs are in the order of these numbers, whose lower half are columns; -1: none
  std::vector<std::int64_t> ranked;
  bool by_position = false;    // or by ID
  double work_when_tried = 1.0;

  // slots with a pair, found by the gradient sweep: those of a block side by side, in room for all
  // candidates.  grad_i W = factor/h0^(D+2) x_ij
  struct Pairs {
    std::vector<int> first, count, near_first, near_count;    // of blocks
    Room<int> further;
    Room<Bits> lanes;           // which lanes have a pair
    Room<float> factor;         // 0 in the others
    Room<int> near;             // slots with a nearest neighbor
    Room<float> near_kernel;    // of those: Wbar_ij h0^D
    Room<Number> near_pull;     // weights safe: force on i = m_i/2 near_pull x_ij
    Room<Number> pull;          // viscous force on i = -m_i/h0^(D+2) pull x_ij, kept for heat
    Room<Number> crowd;         // with artificial stress: (W/W(spacing))^n
  } pairs;
  Numbers mu_max;          // of own: largest approach rate, for a time step limit
  int nuncorrected = 0;    // particles with neighbors and B = 1

  static bool are_alike(const std::vector<TypeData> &types)
  {
    double h = 0.0, spacing = 0.0;
    auto differs = [](double &from, double other) {
      if (from == 0.0) from = other;
      return other != 0.0 && other != from;    // 0: no material, or no particles
    };
    for (const TypeData &type : types)
      if (type.h > 0.0 && (differs(h, type.h) || differs(spacing, type.spacing))) return false;
    return true;
  }
  Sent sent() const override { return {T, LAST, at_da}; }

  // candidates
  struct Arranging;
  void place_columns(const Particles &, const NeighborRows &);
  void arrange_candidates(const Particles &, const NeighborRows &);
  void try_other_order(const Particles &, const NeighborRows &);
  void place_constants(const Particles &, int i, int column);
  double work() const;
  void make_room_for_pairs();

  // slots with a nearest neighbor of a block, and where what is kept of their pairs begins
  struct Nearest {
    const int *slot;
    int count;
    std::size_t pair;
  };
  Nearest nearest(int block) const
  {
    const int first = pairs.near_first[block];
    return {pairs.near.data() + first, pairs.near_count[block], first * std::size_t(LANES)};
  }

  // a sweep's view of them
  using View = typename Base::template SlotColumns<FIXED + D * D + SYMMETRIC + D + 2>;
  class Neighbors : public View {
   public:
    Neighbors(const EulerianSweeps &s, int block, int from, int to, int from2 = 0, int to2 = 0) :
        View(s, s.candidates.gathered, block, from, to, from2, to2)
    {
    }
    void ask_ahead(const int *further, int count) const
    {
      if (count > 0) this->ask_behind(further[count - 1]);
    }
    void ask_ahead(const int *further, const Nearest &near) const
    {
      if (near.count > 0) this->ask_behind(further[near.slot[near.count - 1]]);
    }
  };

  // gradient; of a block
  struct Sums {
    Tensors moment, velocity;    // sum V (x_j-x_i)(x)g and sum V (v_j-v_i)(x)g
    Pack nsum;                   // sum m_j Wbar
  };
  struct Finding;
  template <bool UNIFORM> void find_pairs(int block, Finding &);
  template <bool UNIFORM> void find_factors(int block, Finding &);
  template <bool UNIFORM> Sums accumulate(int block, Finding &);
  int update(const Particles &, int block, const Batch &, Sums &, double dt, Totals &);
  Tensors tension_stress(const Tensors &) const;
  // of a pair
  template <bool UNIFORM> Pack mean_h(const Number *i, const Number *j) const
  {
    return UNIFORM ? Pack(common_h) : 0.5 * (component(i, at_h) + component(j, at_h));
  }
  // support of Wbar of a particle
  template <bool UNIFORM> Pack near_of(const Number *i) const
  {
    return UNIFORM ? Pack(common_near) : component(i, at_near);
  }

  // how much further on the next block's kernel gradients are, of which each slot asks for one
  std::ptrdiff_t kernel_gradients_ahead(int block) const
  {
    return asks_ahead ? pairs.count[block] * std::ptrdiff_t(LANES) : 0;
  }
  // where the slots of the block after the next one are
  void ask_for_slots(int block) const
  {
    if (asks_for_block(block))
      prefetch_list(pairs.further.data() + pairs.first[block + 2], pairs.count[block + 2]);
  }

  // force
  // sums over the pairs of a block, without factors of its own; whole: the viscous forces that no
  // correction touches
  struct PairForces {
    Pack stress[D], g[D], crowded_g[D], pulled[D], whole[D], mu_least;
  };
  template <PairForm FORM> void force_blocks(const Particles &);
  template <PairForm FORM, bool TENSILE, bool UNIFORM>
  [[gnu::always_inline]] inline PairForces sum_pairs(int block);
  template <PairForm FORM, bool TENSILE>
  [[gnu::always_inline]] inline void add_forces_of_pairs(const Particles &, int block,
                                                         const Batch &, const PairForces &);

  // correction: what the force of a pair of nearest neighbors is times m_i/2, of a block.  Where that lies is not read again for each pair, which a
  // compiler would do for members.  CONSERVATIVE: for these weights, others are known by the option
  template <bool CONSERVATIVE> class NearFactors {
   public:
    NearFactors(const EulerianSweeps &s, const Nearest &near, const Number *i) :
        kernels(s.pairs.near_kernel.data() + near.pair),
        pulls(s.safe() ? s.pairs.near_pull.data() + near.pair : nullptr), weights(s.opt.weights),
        own(component(i, LAST))
    {
    }
    // of the nth of them
    [[gnu::always_inline]] Pack operator()(int n, const Number *j) const
    {
      return !CONSERVATIVE && pulls ? load(pulls + n * LANES) : weight(n, j);
    }
    [[gnu::always_inline]] Pack weight(int n, const Number *j) const
    {
      return correction_weight_of_inverse(CONSERVATIVE ? Weights::CONSERVATIVE : weights,
                                          component(j, MASS) * Precision::load(kernels + n * LANES),
                                          own, component(j, LAST));
    }

   private:
    const float *const kernels;
    const Number *const pulls;
    const Weights weights;
    const Pack own;    // 1/n
  };
  template <bool CONSERVATIVE> void correct_block(const Particles &, int block, const Batch &);
  void safe_pulls(int block);

  // heat
  template <bool PULL, bool TENSILE> void add_power(int block, Pack &stress, Pack &viscous) const;
  template <bool EVENLY> Pack corrected_power(int block) const;
  Tensors block_virial(const Particles &, int block, const Batch &) const override;
};

}    // namespace

#endif

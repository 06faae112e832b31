/* ----------------------------------------------------------------------
   The sweeps of the Lagrangian frame: pairs and kernel gradients belong to the
   reference configuration and are never renewed; see sph_solid_sweeps.h.

   The class; its members are in
     sph_solid_lagrangian_partners.h    what is constant between two neighbor lists,
                                        and where the frame ends
     sph_solid_lagrangian_heat.h        heat, virial
     sph_solid_sweeps_lagrangian.cpp    gradient and force

   With X reference positions, V0 reference volumes, g_ij = grad_i W(X_i - X_j):

     M_i  = sum_j V0_j (X_j - X_i) (x) g_ij,  B_i = M_i^-1
     F_i  = 1 + [sum_j V0_j (u_j - u_i) (x) g_ij] B_i,  u = x - X
     F'_i = [sum_j V0_j (v_j - v_i) (x) g_ij] B_i
     L_i  = F'_i (F_i - dt/2 F'_i)^-1            in the middle of the step
     C_i  = J_i F_i^-T B_i^T,  J_i = m_i/(rho_i V0_i)
     f_ij = V0_i V0_j (sigma_i C_i + sigma_j C_j) g_ij

   B makes F exact for linear fields, and the same B in C makes f_ij the exact
   adjoint of F.  Linear momentum is exact since f_ij = -f_ji; angular momentum
   since sum_j V0_j (x_j - x_i) (x) C_i g_ij = J_i 1 and sigma is symmetric.
   Corrected total-Lagrangian SPH: Bonet & Kulasegaram (2002); Ganzenmueller (2015).
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LAGRANGIAN_H
#define LMP_SPH_SOLID_LAGRANGIAN_H

#include "sph_solid_sweeps_base.h"

using namespace SPHSolid;

// of one source file, sph_solid_sweeps_lagrangian.cpp.  That the compiler knows this is worth 5 %
// of a step in two dimensions: it inlines what is called once

namespace {

template <int D> class LagrangianSweeps : public SweepsBase<D, LagrangianRow<D>> {
 public:
  LagrangianSweeps(const Options &o, const std::vector<TypeData> &t) :
      SweepsBase<D, LagrangianRow<D>>(o, t, count_tensors(o))
  {
  }

  void new_neighbors(const Particles &, const NeighborRows &, double) override;
  int gradient(const Particles &, const NeighborRows &, double) override;
  void find_switch(const Particles &, const NeighborRows &) override;
  void force(const Particles &, const NeighborRows &) override;
  void heat(const Particles &, const NeighborRows &, double *, bool) override;
  void virial(const Particles &, const NeighborRows &, double *) override;
  Overload find_overload(const NeighborRows &) const override;
  double memory_usage() const override;

 private:
  using Base = SweepsBase<D, LagrangianRow<D>>;
  using Base::da, Base::da_stride, Base::early, Base::early_totals, Base::extra, Base::image_first,
      Base::image_j, Base::images, Base::keeps_pairs, Base::kin, Base::krow, Base::lonely,
      Base::mu_max, Base::near_weight, Base::needs_correction, Base::nthreads, Base::opt,
      Base::pairs, Base::pull, Base::separation, Base::srow, Base::str, Base::stress_stride,
      Base::types, Base::u, Base::VECTOR, Base::whole_pull;
  using typename Base::Kin;
  using typename Base::Str;

  std::vector<double> nearness;    // q/(q^2 + 0.01), q = |X_ij|/h_ij: eq. 24's factor
  Rows B;                          // of own particles, tensors
  Rows F;                          // the same, where no neighbor reads C
  std::vector<double> nsum;        // n of the correction, own
  std::vector<double> damp;        // of every pair: hourglass force on i = V0_i damp x_ij

  bool viscous() const { return opt.viscosity != Viscosity::NONE; }
  static bool keeps_rates(const Options &o)
  {
    return o.hourglass > 0.0 || needs_rates(pair_form(o.viscosity));
  }
  static int count_tensors(const Options &o)
  {
    return (o.viscosity != Viscosity::NONE ? 1 : 0) + (keeps_rates(o) ? 1 : 0);
  }
  // where in a stress row: C, F'
  int at_C() const { return extra(0); }
  int at_rate() const { return extra(viscous() ? 1 : 0); }

  bool can_keep_heat() const override
  {
    if (!opt.energy) return false;
    return !needs_correction() ||
        (opt.weights == Weights::CONSERVATIVE && opt.heating == Heating::COMPATIBLE);
  }
  void add_due_heat(const Particles &, const NeighborRows &) override;
  bool constant_weights() const override { return true; }
  double own_weight(int i) const override { return kin(i)[Kin::VOLUME]; }
  double switch_weight(int) const override { return 1.0; }    // the factor has V0_j
  double step_factor(int i) const override;
  Overload overload(int i) const;
  double weight_volume(const Particles &p, int i) const override { return p.vref[i]; }

  // X_i - X_j
  Vector<D> reference_separation(int i, int j) const { return separation(i, j, Kin::REFERENCE); }
  double *reference(int row) { return &krow[row * Kin::STRIDE + Kin::REFERENCE]; }
  void place_references(const Particles &, const NeighborRows &);
  void unwrap_references(const Particles &, const NeighborRows &);
  int add_pairs(const Particles &, int i, int n, const int *list, bool nearest, int at);
  void fill_vectors(int i);
  double mass_wbar(const Particles &, int i, int j) const;
  void correct_row(const Particles &, int i);
  void prefetch_pairs(int k) const { prefetch(pairs.factor.data() + k + PAIRS_AHEAD, LANES); }
  // one of own particles' tensors
  static constexpr int TENSOR = Blocks<D>::TENSOR;
  static Tensor<D> tensor(const double *blocks)
  {
    Tensor<D> t;
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) t(a, b) = blocks[Blocks<D>::at(a, b)];
    return t;
  }
  Tensor<D> deformation_gradient(int i) const;

  // of a row, of the heat that is due: what viscosity, correction and hourglass damping of pairs
  // give, up to factors of the row
  struct LateHeat {
    Motion<D> kick;    // da and the velocity that belongs to it
    Pack drift, viscous, corrected, hourglass;
  };
  // of a batch: sum V0 (u_j-u_i)(x)g and sum V0 (v_j-v_i)(x)g; of the heat that is due, the
  // viscous part and that of the hourglass damping
  struct Sums {
    Several<D> displacement[LANES], velocity[LANES];
    double viscous[LANES] = {}, hourglass[LANES] = {};
  };
  template <bool LATE> void accumulate(int i, Sums &, int lane) const;
  void add_late_pairs(const int *j, int k, bool nearest, const Motion<D> *d, LateHeat &) const;
  template <bool LATE>
  int update(const Particles &, const typename Base::Batch &, int n, double dt,
             typename Base::Totals &);
  // velocity of the last evaluation
  const double *early_v(int i) const { return &da[i * da_stride + VECTOR]; }
  void add_late_heat(const Particles &, const typename Base::Batch &, int n,
                     const Tensor<D, Pack> &velocity, Sums &, typename Base::Totals &) const;
  template <class Call> void each_batch(const NeighborRows &, Call);
  template <PairForm FORM, bool HOURGLASS> typename Base::Power force_row(const Particles &, int i);
  template <PairForm FORM, bool HOURGLASS> void force_rows(const Particles &, const NeighborRows &);
  void near_weights(int i) override;
  void pack_constants(const Particles &, int i, double *row) const override;
  template <bool PULL, bool DAMP> typename Base::Power pair_power(int i) const;
};

}    // namespace

#endif

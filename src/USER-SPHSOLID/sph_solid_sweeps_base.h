/* ----------------------------------------------------------------------
   What the sweeps of both frames share: rows of particles, ghosts and mirror
   images, the constitutive update, the acceleration correction, heat.

   A frame fills in where a pair's kernel gradient comes from: present
   positions (sph_solid_sweeps_eulerian.cpp) or those of the reference
   configuration (sph_solid_sweeps_lagrangian.cpp).
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_SWEEPS_BASE_H
#define LMP_SPH_SOLID_SWEEPS_BASE_H

#include "sph_solid_eos.h"
#include "sph_solid_kernel.h"
#include "sph_solid_lanes.h"
#include "sph_solid_strength.h"
#include "sph_solid_sweeps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace SPHSolid {

// the bits of a LAMMPS neighbor index that are the index (NEIGHMASK)
constexpr int INDEX_MASK = 0x1FFFFFFF;

// a particle this close to its image, in smoothing lengths, is on the plane, and
// both are the two halves of one particle
constexpr double COINCIDE = 1.0e-6;

template <int D> class SweepsBase : public Sweeps {
 public:
  // ntensors: how many tensors follow the fixed part of a stress row
  SweepsBase(const Options &o, const std::vector<TypeData> &t, int ntensors_) :
      opt(o), types(t), ntensors(ntensors_), stress_stride(extra(ntensors_))
  {
  }

  void pack_kinematics(const Particles &, const double *const *) override;
  int stress_size() const override { return stress_stride; }
  const double *stress_row(int i) const override { return &srow[i * stress_stride]; }
  void unpack_stress(const Particles &, int, const double *) override;
  void mirror_stress() override;
  bool needs_correction() const override { return opt.viscosity == Viscosity::CORRECT; }
  double *viscous_acceleration(int i) override { return &da[i * VECTOR]; }
  void correction(const Particles &, const NeighborRows &) override;
  double *displacement(int i) override { return &krow[i * Kin::STRIDE + Kin::V]; }
  void heat(const Particles &, const NeighborRows &, double *, bool) override;
  double time_step_limit(const Particles &, const NeighborRows &) const override;
  double sound_speed(int i) const override { return srow[i * stress_stride + Str::C]; }
  int neighbor_count(int i) const override { return pairs.count[i]; }
  double memory_usage() const override;

 protected:
  using Kin = Kinematics<D>;
  using Str = Stress<D>;
  static constexpr int VECTOR = Blocks<D>::VECTOR;

  Options opt;
  std::vector<TypeData> types;
  int ntensors, stress_stride;
  int nown = 0, nparticles = 0, nrows = 0;    // own; own and ghost; with images

  Rows krow, srow, da;           // rows of kinematics, stress, da
  std::vector<double> mu_max;    // largest approach rate of own particles
  std::vector<double> work;      // plastic work of this step, own
  Pairs pairs;
  std::vector<int> image_first, image_j;    // candidates among the images
  std::vector<double> near_weight;          // of pairs of nearest neighbors, for the correction
  bool weights_known = false;
  std::vector<double> pull;    // viscous force on i = -own weight * pull * x_ij, kept for heat
  bool lonely = false;         // a particle here has no nearest neighbor

  const double *kin(int i) const { return &krow[i * Kin::STRIDE]; }
  double *str(int i) { return &srow[i * stress_stride]; }
  const double *str(int i) const { return &srow[i * stress_stride]; }
  // tensor k of those that follow the fixed part of a row
  static constexpr int extra(int k) { return Str::STRIDE + k * Blocks<D>::TENSOR; }

  Vector<D> separation(int i, int j) const
  {
    Vector<D> d;
    for (int a = 0; a < D; a++) d[a] = kin(i)[Kin::X + a] - kin(j)[Kin::X + a];
    return d;
  }
  bool is_lonely(int i) const { return needs_correction() && !(str(i)[Str::NSUM] > 0.0); }

  void size_rows(const Particles &, const NeighborRows &);
  void find_image_candidates(const Particles &, const NeighborRows &, double **x, double reach);
  void mirror_vectors(double *rows, int stride) const;
  double wbar_mass(int i, int j, double r) const;
  double retained_viscosity() const;

  struct Point {
    PointState<D> state;
    PressureState eos;
    Tensor<D> sigma;    // Cauchy stress, tension positive
  };
  Point update_point(const Particles &, int i, const Tensor<D> &L_mid, double dt);
  void write_row(int i, const Point &, const Tensor<D> &T, double K, double nsum);
  static void put_tensor(double *row, const Tensor<D> &t)
  {
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) row[Blocks<D>::at(a, b)] = t(a, b);
  }

  // is the viscous force of every pair kept for heat?
  bool keeps_pairs() const
  {
    if (opt.viscosity == Viscosity::NONE) return false;
    return !needs_correction() || opt.heating == Heating::PRINTED || lonely;
  }
  double whole_pull(int i, int pair) const;
  void lonely_pairs(const Particles &, int i);
  double lonely_power(int i) const;
  const double *u(int i) const { return kin(i) + Kin::V; }    // during heat: displacements

  // of the frame: volume weight of a kinematic row, what a kept pull is to be
  // multiplied with, how much shorter a time step has to be, the weights of the
  // correction, and heat
  virtual double weight_volume(const Particles &, int i) const = 0;
  virtual double own_weight(int i) const = 0;
  virtual double step_factor(int) const { return 1.0; }
  virtual void near_weights(int i) = 0;
  virtual bool constant_weights() const { return false; }    // until neighbors are new

  // what the forces of a row's pairs give to i while all particles move by u; of
  // the stress the half with sigma_i, of the others half of each pair's
  struct Power {
    double stress = 0.0, viscous = 0.0, hourglass = 0.0;
  };
  virtual Power pair_power(int i) const = 0;
  double heat_correction(int i) const;
};

/* ----------------------------------------------------------------------
   storage
------------------------------------------------------------------------- */

template <int D> void SweepsBase<D>::size_rows(const Particles &p, const NeighborRows &list)
{
  nown = p.nlocal;
  nparticles = p.nall;
  nrows = p.nall + (images.any() ? images.count() : 0);
  krow.resize(static_cast<std::size_t>(nrows) * Kin::STRIDE);
  srow.resize(static_cast<std::size_t>(nrows) * stress_stride);
  if (needs_correction()) da.resize(static_cast<std::size_t>(nrows) * VECTOR);
  mu_max.assign(p.nlocal, 0.0);
  work.assign(p.nlocal, 0.0);
  pairs.first.assign(p.nlocal + 1, 0);
  pairs.count.assign(p.nlocal, 0);
  pairs.nearest.assign(p.nlocal, 0);
  weights_known = false;

  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    pairs.first[i + 1] = list.numneigh[i];
  }
  for (int i = 0; i < p.nlocal; i++) {
    if (images.any()) pairs.first[i + 1] += image_first[i + 1] - image_first[i];
    pairs.first[i + 1] = pairs.first[i] + whole_vectors(pairs.first[i + 1]);
  }
  pairs.j.resize(pairs.first[p.nlocal]);
  pairs.factor.resize(pairs.first[p.nlocal]);
}

// candidates among the images: those of every neighbor and of i itself, at x

template <int D>
void SweepsBase<D>::find_image_candidates(const Particles &p, const NeighborRows &list, double **x,
                                          double reach)
{
  if (!images.any()) return;
  images.find(p.nall, x, reach);
  image_first.assign(p.nlocal + 1, 0);
  image_j.clear();
  std::vector<char> listed(p.nlocal, 0);
  for (int ii = 0; ii < list.inum; ii++) listed[list.ilist[ii]] = 1;
  for (int i = 0; i < p.nlocal; i++) {
    image_first[i] = static_cast<int>(image_j.size());
    if (!listed[i]) continue;
    auto add = [&](int j) {
      for (int k = images.first_of(j); k < images.first_of(j + 1); k++)
        image_j.push_back(p.nall + k);
    };
    add(i);
    for (int jj = 0; jj < list.numneigh[i]; jj++) add(list.firstneigh[i][jj] & INDEX_MASK);
  }
  image_first[p.nlocal] = static_cast<int>(image_j.size());
}

/* ---------------------------------------------------------------------- */

template <int D> void SweepsBase<D>::pack_kinematics(const Particles &p, const double *const *v)
{
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads)
#endif
  for (int i = 0; i < p.nall; i++) {
    double *row = &krow[i * Kin::STRIDE];
    const TypeData &t = types[p.type[i]];
    for (int a = 0; a < D; a++) {
      row[Kin::X + a] = p.x[i][a];
      row[Kin::V + a] = v[i][a];
    }
    row[Kin::MASS] = p.mass[i];
    row[Kin::VOLUME] = weight_volume(p, i);
    row[Kin::H] = t.h;
    row[Kin::NEAR] = opt.hbar * t.spacing;
  }
  for (int k = 0; k < nrows - p.nall; k++) {
    const double *from = kin(images.source_of(k));
    double *row = &krow[(p.nall + k) * Kin::STRIDE];
    double sign[3];
    images.signs(k, sign);
    std::copy(from, from + Kin::STRIDE, row);
    images.position<D>(k, from + Kin::X, row + Kin::X);
    for (int a = 0; a < D; a++) row[Kin::V + a] *= sign[a];
  }
}

/* ----------------------------------------------------------------------
   constitutive update of one particle over dt with the velocity gradient in
   the middle of the step; dt = 0: the state as it is
------------------------------------------------------------------------- */

template <int D>
typename SweepsBase<D>::Point SweepsBase<D>::update_point(const Particles &p, int i,
                                                          const Tensor<D> &L_mid, double dt)
{
  const Material &m = types[p.type[i]].material;
  Point point;
  PointState<D> &state = point.state;
  state.rho = p.rho[i];
  state.epl = p.epl[i];
  state.S = symmetric_from_six<D>(p.stress[i]);
  state.Szz = p.stress[i][2];

  work[i] = 0.0;
  if (dt > 0.0) {
    work[i] = advance<D>(m, state, L_mid, dt) * p.mass[i] / state.rho;
    p.rho[i] = state.rho;
    p.epl[i] = state.epl;
    six_from_symmetric<D>(state.S, p.stress[i]);
    state.S = symmetric_from_six<D>(p.stress[i]);    // as a restart file has it
    if (D == 2) p.stress[i][2] = state.Szz;
  }

  const double rho_ref = reference_density(p.mass[i], p.volume[i]);
  point.eos = pressure(m, state.rho, rho_ref, p.e[i]);
  point.sigma = state.S - point.eos.P * Tensor<D>::Identity();
  return point;
}

template <int D>
void SweepsBase<D>::write_row(int i, const Point &point, const Tensor<D> &T, double K, double nsum)
{
  double *row = str(i);
  put_tensor(row + Str::T, T);
  row[Str::K] = K;
  row[Str::RHO] = point.state.rho;
  row[Str::C] = std::sqrt(std::max(point.eos.c2, 0.0));
  row[Str::NSUM] = nsum;
}

/* ----------------------------------------------------------------------
   rows of ghosts and images
------------------------------------------------------------------------- */

template <int D> void SweepsBase<D>::unpack_stress(const Particles &p, int i, const double *row)
{
  std::copy(row, row + stress_stride, str(i));
  p.rho[i] = row[Str::RHO];
}

// a tensor of an image is Q T Q^T with Q = diag(sign): component (a,b) times
// both signs

template <int D> void SweepsBase<D>::mirror_stress()
{
  for (int k = 0; k < nrows - nparticles; k++) {
    const double *from = str(images.source_of(k));
    double *row = str(nparticles + k);
    double sign[3];
    images.signs(k, sign);
    std::copy(from, from + stress_stride, row);
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) {
        row[Str::T + Blocks<D>::at(a, b)] *= sign[a] * sign[b];
        for (int t = 0; t < ntensors; t++) row[extra(t) + Blocks<D>::at(a, b)] *= sign[a] * sign[b];
      }
  }

  lonely = false;
  if (needs_correction())
    for (int i = 0; i < nrows; i++) lonely = lonely || !(str(i)[Str::NSUM] > 0.0);
  if (keeps_pairs()) pull.resize(pairs.j.size());
}

template <int D> void SweepsBase<D>::mirror_vectors(double *rows, int stride) const
{
  for (int k = 0; k < nrows - nparticles; k++) {
    double sign[3];
    images.signs(k, sign);
    for (int a = 0; a < D; a++)
      rows[(nparticles + k) * stride + a] = sign[a] * rows[images.source_of(k) * stride + a];
  }
}

/* ----------------------------------------------------------------------
   correction sweep: replaces the viscous acceleration by its grid-scale part
------------------------------------------------------------------------- */

// m_j Wbar_ij, the support of Wbar being the mean of both

template <int D> double SweepsBase<D>::wbar_mass(int i, int j, double r) const
{
  const double hbar = 0.25 * (kin(i)[Kin::NEAR] + kin(j)[Kin::NEAR]);
  return kin(j)[Kin::MASS] * CubicSpline<D>::w(r, hbar);
}

template <int D> void SweepsBase<D>::correction(const Particles &p, const NeighborRows &list)
{
  mirror_vectors(da.data(), VECTOR);
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads)
#endif
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    if (!weights_known) near_weights(i);
    const int *j = &pairs.j[pairs.first[i]];
    const double *w = &near_weight[pairs.first[i]], *di = &da[i * VECTOR];
    double sum[D] = {};
    for (int k = 0; k < pairs.nearest[i]; k++) {
      const double *dj = &da[j[k] * VECTOR];
      for (int a = 0; a < D; a++) sum[a] += w[k] * (di[a] - dj[a]);
    }
    for (int a = 0; a < D; a++) p.f[i][a] += 0.5 * kin(i)[Kin::MASS] * sum[a];
  }
  weights_known = constant_weights();
}

/* ----------------------------------------------------------------------
   heat: compatible with the pair forces, so that kinetic plus internal
   energy is constant to rounding for any displacement that the kick makes
------------------------------------------------------------------------- */

template <int D>
void SweepsBase<D>::heat(const Particles &, const NeighborRows &list, double *heat, bool book)
{
  mirror_vectors(&krow[Kin::V], Kin::STRIDE);
  double viscous = 0.0, standard = 0.0, damped = 0.0;
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads) reduction(+ : viscous, standard, damped)
#endif
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    const Power power = pair_power(i);
    double q = power.viscous;
    if (needs_correction()) {
      // what the standard viscosity would heat: q has all of it for eq. 30,
      // else the pairs that no correction touches
      if (opt.heating == Heating::COMPATIBLE) {
        q = lonely ? lonely_power(i) : 0.0;
        for (int a = 0; a < D; a++) standard -= kin(i)[Kin::MASS] * da[i * VECTOR + a] * u(i)[a];
      }
      standard += q;
      q += heat_correction(i);
    }
    heat[i] = power.stress + q + power.hourglass;
    viscous += q;
    damped += power.hourglass;
  }
  if (!book) return;
  ledger.viscous_heat += viscous;
  ledger.hourglass += damped;
  if (needs_correction()) ledger.returned += standard - viscous;
}

// the force coefficient of pairs that no correction replaces

template <int D> double SweepsBase<D>::whole_pull(int i, int pair) const
{
  if (!keeps_pairs()) return 0.0;
  if (needs_correction() && !is_lonely(i) && !is_lonely(pairs.j[pair])) return 0.0;
  return own_weight(i) * pull[pair];
}

// standard viscosity of the pairs that the correction must not touch: one of
// the two has no nearest neighbor.  Symmetric, so momentum stays exact

template <int D> void SweepsBase<D>::lonely_pairs(const Particles &p, int i)
{
  for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k++) {
    const double s = whole_pull(i, k);
    const Vector<D> d = separation(i, pairs.j[k]);
    for (int a = 0; a < D; a++) p.f[i][a] -= s * d[a];
  }
}

// half the work of the pairs that the correction leaves alone

template <int D> double SweepsBase<D>::lonely_power(int i) const
{
  double sum = 0.0;
  for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k++) {
    const int j = pairs.j[k];
    const double s = whole_pull(i, k);
    for (int a = 0; a < D; a++) sum += s * (u(i)[a] - u(j)[a]) * (kin(i)[a] - kin(j)[a]);
  }
  return 0.5 * sum;
}

// compatible: -1/4 sum w_ij (u_i - u_j).(da_i - da_j) for symmetric weights;
// shepard weights leak momentum, there the loss of kinetic energy of the
// particle itself becomes heat (exact in total, not Galilean invariant);
// printed: the correction term of eq. 30, 1/2 sum w_ij (u_i - u_j).da_j

template <int D> double SweepsBase<D>::heat_correction(int i) const
{
  const bool printed = opt.heating == Heating::PRINTED;
  const bool shepard = opt.weights == Weights::SHEPARD;
  const double *di = &da[i * VECTOR], *ui = u(i);
  double sum = 0.0;
  for (int k = 0; k < pairs.nearest[i]; k++) {
    const int j = pairs.j[pairs.first[i] + k];
    const double *dj = &da[j * VECTOR], *uj = u(j);
    double power = 0.0;
    for (int a = 0; a < D; a++) {
      if (printed)
        power += 0.5 * (ui[a] - uj[a]) * dj[a];
      else if (shepard)
        power -= 0.5 * ui[a] * (di[a] - dj[a]);
      else
        power -= 0.25 * (ui[a] - uj[a]) * (di[a] - dj[a]);
    }
    sum += near_weight[pairs.first[i] + k] * power;
  }
  return kin(i)[Kin::MASS] * sum;
}

/* ----------------------------------------------------------------------
   h/(c_L + 0.6 (a1 c + a2 |mu|)), the viscous part as far as it is retained
------------------------------------------------------------------------- */

template <int D>
double SweepsBase<D>::time_step_limit(const Particles &p, const NeighborRows &list) const
{
  const double retained = retained_viscosity();
  double limit = 1.0e300;
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    const TypeData &t = types[p.type[i]];
    const double c = str(i)[Str::C], rho = str(i)[Str::RHO];
    const double c_l = std::sqrt(c * c + 4.0 * t.material.shear / (3.0 * rho));
    const double viscous = 0.6 * retained * (opt.a1 * c + opt.a2 * mu_max[i]);
    limit = std::min(limit, step_factor(i) * t.h / (c_l + viscous));
  }
  return limit;
}

template <int D> double SweepsBase<D>::retained_viscosity() const
{
  if (opt.viscosity == Viscosity::NONE) return 0.0;
  return opt.viscosity == Viscosity::CORRECT ? CORRECTION_RETAINS : 1.0;
}

template <int D> double SweepsBase<D>::memory_usage() const
{
  const std::size_t doubles = krow.capacity() + srow.capacity() + da.capacity() +
      mu_max.capacity() + work.capacity() + pull.capacity() + pairs.factor.capacity() +
      near_weight.capacity();
  const std::size_t ints = pairs.first.capacity() + pairs.count.capacity() +
      pairs.nearest.capacity() + pairs.j.capacity() + image_first.capacity() + image_j.capacity();
  return static_cast<double>(doubles * sizeof(double) + ints * sizeof(int));
}

}    // namespace SPHSolid

#endif

/* ----------------------------------------------------------------------
   The sweeps of the Lagrangian frame: pairs and kernel gradients belong to the
   reference configuration and are never renewed; see sph_solid_sweeps.h.

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

#include "sph_solid_sweeps_base.h"

#include <Eigen/Eigenvalues>
#include <atomic>

using namespace SPHSolid;

namespace {

// below this det M a particle has no partners to speak of and B = 1.  Corners
// of a body reach 0.05 and need their B
constexpr double DET_FALLBACK = 0.005;

// the frame ends where the least principal stretch, or the stretch of a pair,
// falls below this
constexpr double LEAST_STRETCH = 0.01;

// the time step shrinks with the least principal stretch, but not further than
// this: a Courant number of 0.6 is then still stable
constexpr double STEP_STRETCH = 0.05;

template <int D> class LagrangianSweeps : public SweepsBase<D> {
 public:
  LagrangianSweeps(const Options &o, const std::vector<TypeData> &t) :
      SweepsBase<D>(o, t, count_tensors(o))
  {
    if (needs_rates()) stress_stride += 1;
  }

  void new_neighbors(const Particles &, const NeighborRows &, double) override;
  int gradient(const Particles &, const NeighborRows &, double) override;
  void force(const Particles &, const NeighborRows &) override;
  void virial(const Particles &, const NeighborRows &, double *) override;
  Overload find_overload(const NeighborRows &) const override;
  double memory_usage() const override;

 private:
  using Base = SweepsBase<D>;
  using Base::da, Base::extra, Base::image_first, Base::image_j, Base::images, Base::keeps_pairs,
      Base::kin, Base::krow, Base::ledger, Base::lonely, Base::mu_max, Base::near_first,
      Base::near_weight, Base::needs_correction, Base::nthreads, Base::opt, Base::pairs, Base::pull,
      Base::separation, Base::srow, Base::str, Base::stress_stride, Base::types, Base::u,
      Base::wbar_mass, Base::whole_pull, Base::work;
  using typename Base::Kin;
  using typename Base::Str;

  std::vector<double> sep[D];      // X_i - X_j of every pair
  std::vector<double> nearness;    // q/(q^2 + 0.01), q = |X_ij|/h_ij: eq. 24's factor
  std::vector<double> B, F;        // of own particles, D x D
  std::vector<double> nsum;        // n of the correction, own
  std::vector<double> damp;        // of every pair: hourglass force on i = V0_i damp x_ij

  bool viscous() const { return opt.viscosity != Viscosity::NONE; }
  bool limited() const { return opt.viscosity == Viscosity::LIMITED; }
  bool needs_rates() const { return opt.hourglass > 0.0 || limited(); }
  static int count_tensors(const Options &o)
  {
    const bool visc = o.viscosity != Viscosity::NONE;
    return (visc ? 1 : 0) + (o.hourglass > 0.0 || o.viscosity == Viscosity::LIMITED ? 1 : 0);
  }
  // where in a stress row: C, F', rho c_L h
  int at_C() const { return extra(0); }
  int at_rate() const { return extra(viscous() ? 1 : 0); }
  int at_impedance() const { return stress_stride - 1; }

  bool constant_weights() const override { return true; }
  double own_weight(int i) const override { return kin(i)[Kin::VOLUME]; }
  double step_factor(int i) const override;
  double weight_volume(const Particles &p, int i) const override { return p.vref[i]; }

  Vector<D> reference_position(const Particles &, int row) const;
  Vector<D> reference_separation(const Particles &, int i, int row) const;
  int add_pairs(const Particles &, int i, int n, const int *list, bool nearest, int at);
  void correct_row(const Particles &, int i);
  Tensor<D> tensor(const std::vector<double> &all, int i) const
  {
    return Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>>(&all[i * D * D]);
  }

  struct Sums {
    Tensor<D> displacement, velocity;    // sum V0 (u_j-u_i)(x)g and sum V0 (v_j-v_i)(x)g
  };
  Sums accumulate(int i) const;
  bool update(const Particles &, int i, double dt);
  template <bool VISCOUS, bool LIMITED, bool HOURGLASS> void force_row(const Particles &, int i);
  template <bool VISCOUS, bool LIMITED, bool HOURGLASS>
  void force_rows(const Particles &, const NeighborRows &);
  void near_weights(int i) override;
  double heat_stress(int i) const override;
  double heat_hourglass(int i) const override;
};

/* ----------------------------------------------------------------------
   partners have new local indices: everything that is constant between two
   such moments
------------------------------------------------------------------------- */

template <int D>
Vector<D> LagrangianSweeps<D>::reference_position(const Particles &p, int row) const
{
  Vector<D> X;
  if (row < p.nall) {
    for (int a = 0; a < D; a++) X[a] = p.xref[row][a];
  } else
    images.template position<D>(row - p.nall, p.xref[images.source_of(row - p.nall)], X.data());
  return X;
}

// X_i - X_j, the nearest one where the box is periodic

template <int D>
Vector<D> LagrangianSweeps<D>::reference_separation(const Particles &p, int i, int row) const
{
  Vector<D> d = reference_position(p, i) - reference_position(p, row);
  for (int a = 0; a < D; a++)
    if (p.period[a] > 0.0) d[a] -= p.period[a] * std::round(d[a] / p.period[a]);
  return d;
}

// append the nearest or the other partners of a list to row i from at on

template <int D>
int LagrangianSweeps<D>::add_pairs(const Particles &p, int i, int n, const int *list, bool nearest,
                                   int at)
{
  for (int jj = 0; jj < n; jj++) {
    const int j = list[jj] & INDEX_MASK;
    const int source = j < p.nall ? j : images.source_of(j - p.nall);
    const TypeData &ti = types[p.type[i]], &tj = types[p.type[source]];
    const double h = 0.5 * (ti.h + tj.h), support = 0.5 * opt.hbar * (ti.spacing + tj.spacing);
    const Vector<D> X = reference_separation(p, i, j);
    const double r = X.norm();
    if ((r < support) != nearest || (!nearest && r >= 2.0 * h)) continue;
    if (j >= p.nall && r < COINCIDE * h) continue;    // on the plane: its own image
    const double q = r / h;
    pairs.j[at] = j;
    pairs.factor[at] = p.vref[source] * CubicSpline<D>::gradient_factor(r, h);
    nearness[at] = q / (q * q + MU_EPSILON);
    for (int a = 0; a < D; a++) sep[a][at] = X[a];
    at++;
  }
  return at;
}

template <int D>
void LagrangianSweeps<D>::new_neighbors(const Particles &p, const NeighborRows &list, double reach)
{
  Base::find_image_candidates(p, list, p.xref, reach);
  Base::size_rows(p, list);
  const std::size_t n = pairs.j.size();
  for (int a = 0; a < D; a++) sep[a].resize(n);
  if (opt.hourglass > 0.0) damp.resize(n);
  nearness.resize(n);
  B.resize(static_cast<std::size_t>(p.nlocal) * D * D);
  F.resize(static_cast<std::size_t>(p.nlocal) * D * D);
  nsum.assign(p.nlocal, 0.0);

  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii], start = pairs.first[i];
    const int nimage = images.any() ? image_first[i + 1] - image_first[i] : 0;
    const int *image = nimage ? &image_j[image_first[i]] : nullptr;
    int at = add_pairs(p, i, list.numneigh[i], list.firstneigh[i], true, start);
    at = add_pairs(p, i, nimage, image, true, at);
    pairs.nearest[i] = needs_correction() ? at - start : 0;
    at = add_pairs(p, i, list.numneigh[i], list.firstneigh[i], false, at);
    at = add_pairs(p, i, nimage, image, false, at);
    pairs.count[i] = at - start;
    correct_row(p, i);
  }
  for (int i = 0; i < p.nlocal; i++) near_first[i + 1] = near_first[i] + pairs.nearest[i];
  near_weight.resize(near_first[p.nlocal]);
}

// B_i and, for the acceleration correction, n_i = sum m_j Wbar(X_ij)

template <int D> void LagrangianSweeps<D>::correct_row(const Particles &p, int i)
{
  Tensor<D> M = Tensor<D>::Zero();
  for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k++) {
    Vector<D> X;
    for (int a = 0; a < D; a++) X[a] = sep[a][k];
    M -= pairs.factor[k] * X * X.transpose();
    if (k >= pairs.first[i] + pairs.nearest[i]) continue;
    const int j = pairs.j[k], source = j < p.nall ? j : images.source_of(j - p.nall);
    const double spacing = 0.5 * (types[p.type[i]].spacing + types[p.type[source]].spacing);
    nsum[i] += p.mass[source] * CubicSpline<D>::w(X.norm(), 0.5 * opt.hbar * spacing);
  }
  const bool enough = M.determinant() >= DET_FALLBACK;
  Base::put_tensor(&B[i * D * D], enough ? Tensor<D>(M.inverse()) : Tensor<D>::Identity());
}

/* ----------------------------------------------------------------------
   gradient sweep
------------------------------------------------------------------------- */

template <int D> typename LagrangianSweeps<D>::Sums LagrangianSweeps<D>::accumulate(int i) const
{
  const int start = pairs.first[i], n = pairs.count[i];
  const int *jlist = &pairs.j[start];
  const double *w = &pairs.factor[start], *kall = krow.data(), *ki = kin(i);
  const double *X = &sep[0][start], *Y = &sep[1][start], *Z = &sep[D - 1][start];
  const double xi = ki[0], yi = ki[1], zi = ki[D - 1];
  const double ui = ki[D], vi = ki[D + 1], wi = ki[2 * D - 1];
  double fxx = 0, fxy = 0, fxz = 0, fyx = 0, fyy = 0, fyz = 0, fzx = 0, fzy = 0, fzz = 0;
  double lxx = 0, lxy = 0, lxz = 0, lyx = 0, lyy = 0, lyz = 0, lzx = 0, lzy = 0, lzz = 0;

#pragma omp simd reduction(+ : fxx, fxy, fxz, fyx, fyy, fyz, fzx, fzy, fzz, lxx, lxy, lxz, lyx, lyy, lyz, lzx, lzy, lzz)
  for (int k = 0; k < n; k++) {
    const double *kj = kall + static_cast<std::int64_t>(jlist[k]) * Kin::STRIDE;
    const double gx = w[k] * X[k], gy = w[k] * Y[k];                // V0_j g_ij
    const double dx = kj[0] - xi + X[k], dy = kj[1] - yi + Y[k];    // u_j - u_i
    const double du = kj[D] - ui, dv = kj[D + 1] - vi;
    fxx += dx * gx;
    fxy += dx * gy;
    fyx += dy * gx;
    fyy += dy * gy;
    lxx += du * gx;
    lxy += du * gy;
    lyx += dv * gx;
    lyy += dv * gy;
    if (D == 3) {
      const double gz = w[k] * Z[k], dz = kj[D - 1] - zi + Z[k], dw = kj[2 * D - 1] - wi;
      fxz += dx * gz;
      fyz += dy * gz;
      fzx += dz * gx;
      fzy += dz * gy;
      fzz += dz * gz;
      lxz += du * gz;
      lyz += dv * gz;
      lzx += dw * gx;
      lzy += dw * gy;
      lzz += dw * gz;
    }
  }

  Sums out;
  if constexpr (D == 2) {
    out.displacement << fxx, fxy, fyx, fyy;
    out.velocity << lxx, lxy, lyx, lyy;
  } else {
    out.displacement << fxx, fxy, fxz, fyx, fyy, fyz, fzx, fzy, fzz;
    out.velocity << lxx, lxy, lxz, lyx, lyy, lyz, lzx, lzy, lzz;
  }
  return out;
}

template <int D>
int LagrangianSweeps<D>::gradient(const Particles &p, const NeighborRows &list, double dt)
{
  std::atomic<int> bad(-1);
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads)
#endif
  for (int ii = 0; ii < list.inum; ii++)
    if (!update(p, list.ilist[ii], dt)) bad = list.ilist[ii];
  for (int ii = 0; ii < list.inum; ii++) ledger.plastic_work += work[list.ilist[ii]];
  return bad;
}

// constitutive update of one particle and what its neighbors read; false if
// its state is not physical

template <int D> bool LagrangianSweeps<D>::update(const Particles &p, int i, double dt)
{
  const Sums sums = accumulate(i);
  const Tensor<D> correction = tensor(B, i);
  const Tensor<D> Fi = Tensor<D>::Identity() + sums.displacement * correction;
  const Tensor<D> rate = sums.velocity * correction;
  Base::put_tensor(&F[i * D * D], Fi);
  Tensor<D> L = Tensor<D>::Zero();
  if (dt > 0.0) L = rate * Tensor<D>(Fi - 0.5 * dt * rate).inverse();
  const auto point = Base::update_point(p, i, L, dt);

  const double rho = point.state.rho, J = p.mass[i] / (rho * p.vref[i]);
  const Tensor<D> C = J * Fi.inverse().transpose() * correction.transpose();
  Base::write_row(i, point, point.sigma * C, p.vref[i], nsum[i]);
  double *row = str(i);
  if (viscous()) Base::put_tensor(row + at_C(), C);
  if (needs_rates()) {
    const TypeData &t = types[p.type[i]];
    Base::put_tensor(row + at_rate(), rate);
    row[at_impedance()] =
        rho * t.h * std::sqrt(row[Str::C] * row[Str::C] + 4.0 * t.material.shear / (3.0 * rho));
  }
  return rho > 0.0 && std::isfinite(point.eos.P) && std::isfinite(point.state.S.sum()) &&
      std::isfinite(C.sum());
}

/* ----------------------------------------------------------------------
   force sweep
------------------------------------------------------------------------- */

template <int D> void LagrangianSweeps<D>::force(const Particles &p, const NeighborRows &list)
{
  const bool damped = opt.hourglass > 0.0;
  if (!viscous())
    damped ? force_rows<false, false, true>(p, list) : force_rows<false, false, false>(p, list);
  else if (limited())
    damped ? force_rows<true, true, true>(p, list) : force_rows<true, true, false>(p, list);
  else
    damped ? force_rows<true, false, true>(p, list) : force_rows<true, false, false>(p, list);
}

template <int D>
template <bool VISCOUS, bool LIMITED, bool HOURGLASS>
void LagrangianSweeps<D>::force_rows(const Particles &p, const NeighborRows &list)
{
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads)
#endif
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    force_row<VISCOUS, LIMITED, HOURGLASS>(p, i);
    if (VISCOUS && lonely) Base::lonely_pairs(p, i);
  }
}

// a . T b.  Components by name, here and below: arrays that are private to a
// vector loop would go through memory

template <int D>
inline double bilinear(const double *T, double ax, double ay, double az, double bx, double by,
                       double bz)
{
  if (D == 2) return ax * (T[0] * bx + T[1] * by) + ay * (T[D] * bx + T[D + 1] * by);
  return ax * (T[0] * bx + T[1] * by + T[2] * bz) +
      ay * (T[D] * bx + T[D + 1] * by + T[D + 2] * bz) +
      az * (T[2 * D] * bx + T[2 * D + 1] * by + T[D * D - 1] * bz);
}

// f_i = V0_i sum_j V0_j [(T_i + T_j) g_ij - Pi_ij G_ij x_ij] + hourglass.
// viscosity: central, Pi = rho mu (a2 mu - a1 c) with eq. 24's mu at the
// reference distance, G = min(0, x.(C_i+C_j)g/2)/x^2 the kernel gradient along x.
// hourglass: c rho c_L h w_ij nu_ij with nu_ij the part along x_ij of
// v_ij - (F'_i+F'_j)/2 X_ij, which no linear field contains, and
// w_ij = -g_ij.X_ij/X_ij^2

template <int D>
template <bool VISCOUS, bool LIMITED, bool HOURGLASS>
void LagrangianSweeps<D>::force_row(const Particles &p, int i)
{
  const int start = pairs.first[i], n = pairs.count[i];
  const int *jlist = &pairs.j[start];
  const double *w = &pairs.factor[start];
  const double *ki = kin(i), *si = str(i), *kall = krow.data(), *sall = srow.data();
  const double *X = &sep[0][start], *Y = &sep[1][start], *Z = &sep[D - 1][start];
  const double *close = &nearness[start];
  const int ss = stress_stride, c_at = at_C(), r_at = at_rate(), z_at = at_impedance();
  const double xi = ki[0], yi = ki[1], zi = ki[D - 1];
  const double ui = ki[D], vi = ki[D + 1], wi = ki[2 * D - 1];
  const double a1 = opt.a1, a2 = opt.a2, hg = 0.5 * opt.hourglass;
  const double rho_i = si[Str::RHO], c_i = si[Str::C], impedance = HOURGLASS ? si[z_at] : 0.0;
  double T[D * D], C[D * D], rate[D * D];
  std::copy(si, si + D * D, T);
  if (VISCOUS) std::copy(si + c_at, si + c_at + D * D, C);
  if (LIMITED || HOURGLASS) std::copy(si + r_at, si + r_at + D * D, rate);
  const bool keep = keeps_pairs(), correct = needs_correction();
  double *kept = keep ? &pull[start] : nullptr;    // V0_j Pi_ij G_ij
  double *damped = HOURGLASS ? &damp[start] : nullptr;
  // in a correction, pairs that touch a particle without nearest neighbors
  // are left to lonely_pairs()
  const double ok_i = (!correct || si[Str::NSUM] > 0.0) ? 1.0 : 0.0;
  double mu_least = 0;
  double fx = 0, fy = 0, fz = 0, qx = 0, qy = 0, qz = 0;

#pragma omp simd reduction(+ : fx, fy, fz, qx, qy, qz) reduction(min : mu_least)
  for (int k = 0; k < n; k++) {
    const double *kj = kall + static_cast<std::int64_t>(jlist[k]) * Kin::STRIDE;
    const double *sj = sall + static_cast<std::int64_t>(jlist[k]) * ss;
    const double Rx = X[k], Ry = Y[k], Rz = (D == 3) ? Z[k] : 0.0;
    if (D == 2) {
      fx += w[k] * ((T[0] + sj[0]) * Rx + (T[1] + sj[1]) * Ry);
      fy += w[k] * ((T[D] + sj[D]) * Rx + (T[D + 1] + sj[D + 1]) * Ry);
    } else {
      fx += w[k] * ((T[0] + sj[0]) * Rx + (T[1] + sj[1]) * Ry + (T[2] + sj[2]) * Rz);
      fy +=
          w[k] * ((T[D] + sj[D]) * Rx + (T[D + 1] + sj[D + 1]) * Ry + (T[D + 2] + sj[D + 2]) * Rz);
      fz += w[k] *
          ((T[2 * D] + sj[2 * D]) * Rx + (T[2 * D + 1] + sj[2 * D + 1]) * Ry +
           (T[D * D - 1] + sj[D * D - 1]) * Rz);
    }
    if (!VISCOUS && !HOURGLASS) continue;

    const double x = xi - kj[0], y = yi - kj[1], z = (D == 3) ? zi - kj[D - 1] : 0.0;
    const double r2 = x * x + y * y + z * z;
    double vr = (ui - kj[D]) * x + (vi - kj[D + 1]) * y;
    if (D == 3) vr += (wi - kj[2 * D - 1]) * z;
    double l_i = 0.0, l_j = 0.0;
    if (LIMITED || HOURGLASS) {
      l_i = bilinear<D>(rate, x, y, z, Rx, Ry, Rz);
      l_j = bilinear<D>(sj + r_at, x, y, z, Rx, Ry, Rz);
    }
    if (HOURGLASS) {
      const double s = hg * (impedance + sj[z_at]) * w[k] * (vr - 0.5 * (l_i + l_j)) / r2;
      damped[k] = s;
      fx += s * x;
      fy += s * y;
      if (D == 3) fz += s * z;
    }

    if (VISCOUS) {
      if (LIMITED) vr = limited_jump(vr, l_i, l_j);
      const double closing = vr < 0.0 ? vr : 0.0;
      const double mu = closing * close[k] / std::sqrt(r2);
      const double rho = 0.5 * (rho_i + sj[Str::RHO]);
      const double Pi = rho * mu * (a2 * mu - a1 * 0.5 * (c_i + sj[Str::C]));
      const double along = 0.5 * w[k] *
          (bilinear<D>(C, x, y, z, Rx, Ry, Rz) + bilinear<D>(sj + c_at, x, y, z, Rx, Ry, Rz));
      const double s = Pi * (along < 0.0 ? along : 0.0) / r2;    // V0_j Pi G
      if (keep) kept[k] = s;
      const double masked = correct ? (sj[Str::NSUM] > 0.0 ? ok_i * s : 0.0) : s;
      qx -= masked * x;
      qy -= masked * y;
      if (D == 3) qz -= masked * z;
      mu_least = mu < mu_least ? mu : mu_least;
    }
  }

  const double f[3] = {fx, fy, fz}, q[3] = {qx, qy, qz};
  const double V0 = ki[Kin::VOLUME], per_mass = V0 / ki[Kin::MASS];
  for (int a = 0; a < D; a++) {
    p.f[i][a] += V0 * f[a];
    if (VISCOUS && correct)
      da[i * D + a] = per_mass * q[a];
    else if (VISCOUS)
      p.f[i][a] += V0 * q[a];
  }
  mu_max[i] = -mu_least;
}

// over the nearest partners: constant until the partners have new indices

template <int D> void LagrangianSweeps<D>::near_weights(int i)
{
  for (int k = 0; k < pairs.nearest[i]; k++) {
    const int at = pairs.first[i] + k, j = pairs.j[at];
    double r2 = 0.0;
    for (int a = 0; a < D; a++) r2 += sep[a][at] * sep[a][at];
    near_weight[near_first[i] + k] = correction_weight(opt.weights, wbar_mass(i, j, std::sqrt(r2)),
                                                       str(i)[Str::NSUM], str(j)[Str::NSUM]);
  }
}

/* ----------------------------------------------------------------------
   heat
------------------------------------------------------------------------- */

// V0_i T_i : sum_j V0_j (u_j - u_i) (x) g, exact adjoint of the force

template <int D> double LagrangianSweeps<D>::heat_stress(int i) const
{
  const int start = pairs.first[i], n = pairs.count[i];
  const int *jlist = &pairs.j[start];
  const double *w = &pairs.factor[start], *si = str(i), *uall = u.data();
  const double *X = &sep[0][start], *Y = &sep[1][start], *Z = &sep[D - 1][start];
  const double ux = uall[i * D], uy = uall[i * D + 1], uz = uall[i * D + D - 1];
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (int k = 0; k < n; k++) {
    const double *uj = uall + static_cast<std::int64_t>(jlist[k]) * D;
    const double power = bilinear<D>(si, uj[0] - ux, uj[1] - uy, uj[D - 1] - uz, X[k], Y[k], Z[k]);
    sum += w[k] * power;
  }
  return kin(i)[Kin::VOLUME] * sum;
}

template <int D> double LagrangianSweeps<D>::heat_hourglass(int i) const
{
  if (!(opt.hourglass > 0.0)) return 0.0;
  return -0.5 * kin(i)[Kin::VOLUME] * Base::central_power(i, &damp[pairs.first[i]]);
}

/* ----------------------------------------------------------------------
   virial, only on steps that ask for it
------------------------------------------------------------------------- */

template <int D>
void LagrangianSweeps<D>::virial(const Particles &, const NeighborRows &list, double *six)
{
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    const double V0 = kin(i)[Kin::VOLUME], *si = str(i);
    for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k++) {
      const int j = pairs.j[k], n = k - pairs.first[i];
      const Vector<D> x = separation(i, j);
      for (int a = 0; a < D; a++) {
        double f = 0.0;
        for (int b = 0; b < D; b++)
          f += V0 * pairs.factor[k] * (si[a * D + b] + str(j)[a * D + b]) * sep[b][k];
        if (opt.hourglass > 0.0) f += V0 * damp[k] * x[a];
        f -= whole_pull(i, k) * x[a];
        if (n < pairs.nearest[i])
          f += 0.5 * kin(i)[Kin::MASS] * near_weight[near_first[i] + n] *
              (da[i * D + a] - da[j * D + a]);
        for (int b = 0; b <= a; b++) six[VOIGT[b][a]] += 0.5 * x[b] * f;
      }
    }
  }
}

/* ----------------------------------------------------------------------
   particles come closer with the least principal stretch, and so must the
   time step
------------------------------------------------------------------------- */

template <int D> double least_stretch(const Tensor<D> &F)
{
  Eigen::SelfAdjointEigenSolver<Tensor<D>> eigen;
  eigen.computeDirect(F.transpose() * F, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(eigen.eigenvalues()[0], 0.0));
}

template <int D> double LagrangianSweeps<D>::step_factor(int i) const
{
  return std::min(1.0, std::max(STEP_STRETCH, least_stretch<D>(tensor(F, i))));
}

/* ----------------------------------------------------------------------
   where the frame ends: F turned over, squeezed flat, or two partners on top
   of each other
------------------------------------------------------------------------- */

template <int D> Overload LagrangianSweeps<D>::find_overload(const NeighborRows &list) const
{
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    if (pairs.count[i] == 0) continue;
    const Tensor<D> Fi = tensor(F, i);
    const double J = Fi.determinant();
    if (!(J > 0.0)) return {Overload::TURNED_OVER, i, J};
    const double s = least_stretch<D>(Fi);
    if (s < LEAST_STRETCH) return {Overload::STRETCH, i, s};
    for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k++) {
      double X2 = 0.0;
      for (int a = 0; a < D; a++) X2 += sep[a][k] * sep[a][k];
      const double x2 = separation(i, pairs.j[k]).squaredNorm();
      if (x2 < LEAST_STRETCH * LEAST_STRETCH * X2)
        return {Overload::OVERLAP, i, std::sqrt(x2 / X2)};
    }
  }
  return {};
}

template <int D> double LagrangianSweeps<D>::memory_usage() const
{
  std::size_t doubles =
      nearness.capacity() + B.capacity() + F.capacity() + nsum.capacity() + damp.capacity();
  for (int a = 0; a < D; a++) doubles += sep[a].capacity();
  return Base::memory_usage() + static_cast<double>(doubles * sizeof(double));
}

}    // namespace

/* ---------------------------------------------------------------------- */

template <int D>
std::unique_ptr<Sweeps> SPHSolid::lagrangian_sweeps(const Options &o,
                                                    const std::vector<TypeData> &t)
{
  return std::make_unique<LagrangianSweeps<D>>(o, t);
}

template std::unique_ptr<Sweeps> SPHSolid::lagrangian_sweeps<2>(const Options &,
                                                                const std::vector<TypeData> &);
template std::unique_ptr<Sweeps> SPHSolid::lagrangian_sweeps<3>(const Options &,
                                                                const std::vector<TypeData> &);

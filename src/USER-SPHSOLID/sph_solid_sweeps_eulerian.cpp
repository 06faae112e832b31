/* ----------------------------------------------------------------------
   The sweeps of the Eulerian frame: neighbors and kernel gradients belong to
   the present positions; see sph_solid_sweeps.h.
------------------------------------------------------------------------- */

#include "sph_solid_sweeps_base.h"
#include "sph_solid_tensile.h"

#include <atomic>

using namespace SPHSolid;

namespace {

// below this det of sum V (x_j - x_i) (x) grad W a particle sees too little of
// its surroundings to correct anything: B = 1.  0.2 gave up the foot of a Taylor
// rod too early (0.03 of its kinetic energy at h = 1.3 spacings, 0.018 with 0.1)
constexpr double DET_FALLBACK = 0.1;

template <int D> class EulerianSweeps : public SweepsBase<D> {
 public:
  EulerianSweeps(const Options &o, const std::vector<TypeData> &t) :
      SweepsBase<D>(o, t, o.tensile ? 1 : 0)
  {
  }

  void new_neighbors(const Particles &, const NeighborRows &, double) override;
  int gradient(const Particles &, const NeighborRows &, double) override;
  void force(const Particles &, const NeighborRows &) override;
  void virial(const Particles &, const NeighborRows &, double *) override;

 private:
  using Base = SweepsBase<D>;
  using Base::extra, Base::image_first, Base::image_j, Base::images, Base::kin, Base::krow,
      Base::ledger, Base::lonely, Base::mu_max, Base::near_first, Base::near_weight,
      Base::needs_correction, Base::nthreads, Base::opt, Base::pairs, Base::pull, Base::separation,
      Base::srow, Base::str, Base::stress_stride, Base::types, Base::u, Base::wbar_mass,
      Base::whole_pull, Base::work, Base::keeps_pairs, Base::da;
  using typename Base::Kin;
  using typename Base::Str;

  double own_weight(int i) const override { return kin(i)[Kin::MASS]; }
  double weight_volume(const Particles &p, int i) const override
  {
    return p.mass[i] / p.rho_weight[i];
  }

  double crowding_of(int i, int j, double r) const
  {
    const double spacing = 0.5 * (kin(i)[Kin::NEAR] + kin(j)[Kin::NEAR]) / opt.hbar;
    return crowding<D>(r, 0.5 * (kin(i)[Kin::H] + kin(j)[Kin::H]), spacing, opt.tensile_n);
  }

  struct Sums {
    Tensor<D> moment, velocity;    // sum V (x_j-x_i)(x)g and sum V (v_j-v_i)(x)g
    double nsum;                   // sum m_j Wbar
  };
  struct Scratch;
  int gather(int i, int n, const int *list, int offset, Scratch &);
  Sums accumulate(int i, Scratch &, int n);
  bool update(const Particles &, int i, const Sums &, double dt);
  template <bool VISCOUS, bool TENSILE> void force_row(const Particles &, int i);
  template <bool VISCOUS> void force_rows(const Particles &, const NeighborRows &);
  void near_weights(int i) override;
  double heat_stress(int i) const override;
};

/* ---------------------------------------------------------------------- */

template <int D>
void EulerianSweeps<D>::new_neighbors(const Particles &p, const NeighborRows &list, double reach)
{
  Base::find_image_candidates(p, list, p.x, reach);
  Base::size_rows(p, list);
}

/* ----------------------------------------------------------------------
   gradient sweep
------------------------------------------------------------------------- */

// neighbors inside the kernel, component by component, nearest ones first

template <int D> struct EulerianSweeps<D>::Scratch {
  std::vector<int> j, far_j;
  std::vector<double> d[D], dv[D], vol, h, factor;
  int nnear = 0;

  void reserve(std::size_t n)
  {
    if (j.size() >= n) return;
    j.resize(n);
    far_j.resize(n);
    for (int a = 0; a < D; a++) {
      d[a].resize(n);
      dv[a].resize(n);
    }
    vol.resize(n);
    h.resize(n);
    factor.resize(n);
  }
};

// append those of a candidate list that are inside the kernel: near ones to
// j (from the front), others to far_j; returns how many far ones there are

template <int D> int EulerianSweeps<D>::gather(int i, int n, const int *list, int nfar, Scratch &s)
{
  const double *ri = kin(i);
  for (int jj = 0; jj < n; jj++) {
    const int j = list[jj] & INDEX_MASK;
    const double *rj = kin(j);
    double r2 = 0.0;
    for (int a = 0; a < D; a++) {
      const double d = ri[a] - rj[a];
      r2 += d * d;
    }
    const double reach = ri[Kin::H] + rj[Kin::H];    // 2 h_ij
    const double near = 0.5 * (ri[Kin::NEAR] + rj[Kin::NEAR]);
    if (j >= this->nparticles && r2 < COINCIDE * COINCIDE * reach * reach) continue;    // itself
    if (r2 < near * near)
      s.j[s.nnear++] = j;
    else if (r2 < reach * reach)
      s.far_j[nfar++] = j;
  }
  return nfar;
}

template <int D>
typename EulerianSweeps<D>::Sums EulerianSweeps<D>::accumulate(int i, Scratch &s, int n)
{
  const double *ri = kin(i);
  for (int k = 0; k < n; k++) {
    const double *rj = kin(s.j[k]);
    for (int a = 0; a < D; a++) {
      s.d[a][k] = rj[Kin::X + a] - ri[Kin::X + a];
      s.dv[a][k] = rj[Kin::V + a] - ri[Kin::V + a];
    }
    s.vol[k] = rj[Kin::VOLUME];
    s.h[k] = 0.5 * (ri[Kin::H] + rj[Kin::H]);
  }

  const double *dx = s.d[0].data(), *dy = s.d[1].data(), *dz = s.d[D - 1].data();
  const double *ux = s.dv[0].data(), *uy = s.dv[1].data(), *uz = s.dv[D - 1].data();
  const double *vol = s.vol.data(), *h = s.h.data();
  double *factor = s.factor.data();
  double mxx = 0, mxy = 0, mxz = 0, myy = 0, myz = 0, mzz = 0;
  double lxx = 0, lxy = 0, lxz = 0, lyx = 0, lyy = 0, lyz = 0, lzx = 0, lzy = 0, lzz = 0;

  // grad_i W = F (x_i - x_j) = -F d: both sums of positive definite sign are -V F
#pragma omp simd reduction(+ : mxx, mxy, mxz, myy, myz, mzz, lxx, lxy, lxz, lyx, lyy, lyz, lzx, lzy, lzz)
  for (int k = 0; k < n; k++) {
    double r2 = dx[k] * dx[k] + dy[k] * dy[k];
    if (D == 3) r2 += dz[k] * dz[k];
    const double F = CubicSpline<D>::gradient_factor(std::sqrt(r2), h[k]);
    factor[k] = F;
    const double w = -vol[k] * F;
    const double gx = w * dx[k], gy = w * dy[k];
    mxx += gx * dx[k];
    mxy += gx * dy[k];
    myy += gy * dy[k];
    lxx += gx * ux[k];
    lxy += gy * ux[k];
    lyx += gx * uy[k];
    lyy += gy * uy[k];
    if (D == 3) {
      const double gz = w * dz[k];
      mxz += gx * dz[k];
      myz += gy * dz[k];
      mzz += gz * dz[k];
      lxz += gz * ux[k];
      lyz += gz * uy[k];
      lzx += gx * uz[k];
      lzy += gy * uz[k];
      lzz += gz * uz[k];
    }
  }

  Sums out;
  if constexpr (D == 2) {
    out.moment << mxx, mxy, mxy, myy;
    out.velocity << lxx, lxy, lyx, lyy;
  } else {
    out.moment << mxx, mxy, mxz, mxy, myy, myz, mxz, myz, mzz;
    out.velocity << lxx, lxy, lxz, lyx, lyy, lyz, lzx, lzy, lzz;
  }
  out.nsum = 0.0;
  return out;
}

template <int D>
int EulerianSweeps<D>::gradient(const Particles &p, const NeighborRows &list, double dt)
{
  std::atomic<int> bad(-1);
  const bool correct = needs_correction();

#if defined(_OPENMP)
#pragma omp parallel num_threads(nthreads)
#endif
  {
    Scratch s;
#if defined(_OPENMP)
#pragma omp for schedule(static)
#endif
    for (int ii = 0; ii < list.inum; ii++) {
      const int i = list.ilist[ii];
      const int start = pairs.first[i];
      s.reserve(pairs.first[i + 1] - start);
      s.nnear = 0;
      int nfar = gather(i, list.numneigh[i], list.firstneigh[i], 0, s);
      if (images.any())
        nfar = gather(i, image_first[i + 1] - image_first[i], &image_j[image_first[i]], nfar, s);
      const int n = s.nnear + nfar;
      std::copy(s.far_j.begin(), s.far_j.begin() + nfar, s.j.begin() + s.nnear);

      Sums sums = accumulate(i, s, n);
      if (correct)
        for (int k = 0; k < s.nnear; k++)
          sums.nsum += wbar_mass(i, s.j[k], separation(i, s.j[k]).norm());
      std::copy(s.j.begin(), s.j.begin() + n, pairs.j.begin() + start);
      std::copy(s.factor.begin(), s.factor.begin() + n, pairs.factor.begin() + start);
      pairs.count[i] = n;
      pairs.nearest[i] = correct ? s.nnear : 0;
      if (!update(p, i, sums, dt)) bad = i;
    }
  }

  for (int i = 0; i < p.nlocal; i++) near_first[i + 1] = near_first[i] + pairs.nearest[i];
  for (int ii = 0; ii < list.inum; ii++) ledger.plastic_work += work[list.ilist[ii]];
  return bad;
}

// constitutive update of one particle and what its neighbors read; false if
// its state is not physical

template <int D>
bool EulerianSweeps<D>::update(const Particles &p, int i, const Sums &sums, double dt)
{
  Tensor<D> B = Tensor<D>::Identity();
  if (opt.corrected && sums.moment.determinant() >= DET_FALLBACK) B = sums.moment.inverse();
  Tensor<D> L = Tensor<D>::Zero();
  if (dt > 0.0) L = midpoint_velocity_gradient<D>(sums.velocity * B, dt);
  const auto point = Base::update_point(p, i, L, dt);

  const double rho = point.state.rho, inv_rho2 = 1.0 / (rho * rho);
  auto weighted = [&](const Tensor<D> &sigma) {
    return opt.corrected ? Tensor<D>(sigma * B.transpose()) : Tensor<D>(sigma * inv_rho2);
  };
  Base::write_row(i, point, weighted(point.sigma), opt.corrected ? p.mass[i] / rho : p.mass[i],
                  sums.nsum);
  if (opt.tensile)
    Base::put_tensor(str(i) + extra(0),
                     weighted(artificial_stress<D>(point.sigma, opt.tensile_eps)));
  return rho > 0.0 && std::isfinite(point.eos.P) && std::isfinite(point.state.S.sum()) &&
      std::isfinite(sums.moment.sum());
}

/* ----------------------------------------------------------------------
   force sweep
------------------------------------------------------------------------- */

template <int D> void EulerianSweeps<D>::force(const Particles &p, const NeighborRows &list)
{
  if (opt.viscosity == Viscosity::NONE)
    force_rows<false>(p, list);
  else
    force_rows<true>(p, list);
}

template <int D>
template <bool VISCOUS>
void EulerianSweeps<D>::force_rows(const Particles &p, const NeighborRows &list)
{
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads)
#endif
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    if (opt.tensile)
      force_row<VISCOUS, true>(p, i);
    else
      force_row<VISCOUS, false>(p, i);
    if (VISCOUS && lonely) Base::lonely_pairs(p, i);
  }
}

// f_i = K_i sum_j K_j (T_i + T_j) g_ij - m_i sum_j m_j Pi_ij g_ij, g = F x_ij

template <int D>
template <bool VISCOUS, bool TENSILE>
void EulerianSweeps<D>::force_row(const Particles &p, int i)
{
  const int start = pairs.first[i], n = pairs.count[i];
  const int *jlist = &pairs.j[start];
  const double *factor = &pairs.factor[start];
  const double *ki = kin(i), *si = str(i);
  const double *kall = krow.data(), *sall = srow.data();
  const int ss = stress_stride;
  const double xi = ki[0], yi = ki[1], zi = ki[D - 1];
  const double ui = ki[D], vi = ki[D + 1], wi = ki[2 * D - 1];
  const double hi = ki[Kin::H], rhoi = si[Str::RHO], ci = si[Str::C];
  const double a1 = opt.a1, a2 = opt.a2;
  const bool keep = keeps_pairs();
  double *kept = keep ? &pull[start] : nullptr;    // m_j Pi_ij F_ij
  // in a correction, pairs that touch a particle without nearest neighbors
  // are left to lonely_pairs()
  const bool correct = needs_correction();
  const double ok_i = (!correct || si[Str::NSUM] > 0.0) ? 1.0 : 0.0;

  double fx = 0, fy = 0, fz = 0, qx = 0, qy = 0, qz = 0, mu_least = 0;

#pragma omp simd reduction(+ : fx, fy, fz, qx, qy, qz) reduction(min : mu_least)
  for (int k = 0; k < n; k++) {
    const double *kj = kall + static_cast<std::int64_t>(jlist[k]) * Kin::STRIDE;
    const double *sj = sall + static_cast<std::int64_t>(jlist[k]) * ss;
    const double dx = xi - kj[0], dy = yi - kj[1];
    const double dz = (D == 3) ? zi - kj[D - 1] : 0.0;
    const double F = factor[k];

    double txx = si[0] + sj[0], txy = si[1] + sj[1];
    double tyx = si[D] + sj[D], tyy = si[D + 1] + sj[D + 1];
    double txz = 0, tyz = 0, tzx = 0, tzy = 0, tzz = 0;
    if (D == 3) {
      txz = si[2] + sj[2];
      tyz = si[D + 2] + sj[D + 2];
      tzx = si[2 * D] + sj[2 * D];
      tzy = si[2 * D + 1] + sj[2 * D + 1];
      tzz = si[D * D - 1] + sj[D * D - 1];
    }
    if (TENSILE) {
      const double *ri = si + extra(0), *rj = sj + extra(0);
      const double r = std::sqrt(dx * dx + dy * dy + dz * dz);
      const double fn = crowding_of(i, jlist[k], r);
      txx += fn * (ri[0] + rj[0]);
      txy += fn * (ri[1] + rj[1]);
      tyx += fn * (ri[D] + rj[D]);
      tyy += fn * (ri[D + 1] + rj[D + 1]);
      if (D == 3) {
        txz += fn * (ri[2] + rj[2]);
        tyz += fn * (ri[D + 2] + rj[D + 2]);
        tzx += fn * (ri[2 * D] + rj[2 * D]);
        tzy += fn * (ri[2 * D + 1] + rj[2 * D + 1]);
        tzz += fn * (ri[D * D - 1] + rj[D * D - 1]);
      }
    }
    const double w = sj[Str::K] * F;
    fx += w * (txx * dx + txy * dy + txz * dz);
    fy += w * (tyx * dx + tyy * dy + tyz * dz);
    if (D == 3) fz += w * (tzx * dx + tzy * dy + tzz * dz);

    if (VISCOUS) {
      double r2 = dx * dx + dy * dy;
      double vr = (ui - kj[D]) * dx + (vi - kj[D + 1]) * dy;
      if (D == 3) {
        r2 += dz * dz;
        vr += (wi - kj[2 * D - 1]) * dz;
      }
      const double mu = approach_rate(vr, r2, 0.5 * (hi + kj[Kin::H]));
      const double Pi =
          monaghan_pi(a1, a2, 0.5 * (ci + sj[Str::C]), 0.5 * (rhoi + sj[Str::RHO]), mu);
      const double ok_j = sj[Str::NSUM] > 0.0 ? ok_i : 0.0;
      const double q = kj[Kin::MASS] * Pi * F;
      if (keep) kept[k] = q;
      const double masked = correct ? ok_j * q : q;
      qx -= masked * dx;
      qy -= masked * dy;
      if (D == 3) qz -= masked * dz;
      mu_least = mu < mu_least ? mu : mu_least;
    }
  }

  double *f = p.f[i];
  const double K = si[Str::K], mass = ki[Kin::MASS];
  const double stress_force[3] = {K * fx, K * fy, K * fz}, acceleration[3] = {qx, qy, qz};
  for (int a = 0; a < D; a++) {
    f[a] += stress_force[a];
    if (VISCOUS && correct)
      da[i * D + a] = acceleration[a];
    else if (VISCOUS)
      f[a] += mass * acceleration[a];
  }
  mu_max[i] = -mu_least;
}

template <int D> void EulerianSweeps<D>::near_weights(int i)
{
  for (int k = 0; k < pairs.nearest[i]; k++) {
    const int j = pairs.j[pairs.first[i] + k];
    const double m_wbar = wbar_mass(i, j, separation(i, j).norm());
    near_weight[near_first[i] + k] =
        correction_weight(opt.weights, m_wbar, str(i)[Str::NSUM], str(j)[Str::NSUM]);
  }
}

/* ----------------------------------------------------------------------
   heat
------------------------------------------------------------------------- */

// stress power K_i T_i : sum_j K_j (u_j - u_i) (x) g: the sigma_i half of
// eq. 20, exact adjoint of the force

template <int D> double EulerianSweeps<D>::heat_stress(int i) const
{
  const int start = pairs.first[i], n = pairs.count[i];
  const double *ki = kin(i), *si = str(i), *kall = krow.data(), *sall = srow.data();
  const double *uall = u.data(), *uown = uall + i * D;
  const int ss = stress_stride;
  const bool tensile = opt.tensile;
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (int k = 0; k < n; k++) {
    const std::int64_t j = pairs.j[start + k];
    const double *kj = kall + j * Kin::STRIDE, *uj = uall + j * D;
    const double w = sall[j * ss + Str::K] * pairs.factor[start + k];
    double d[3] = {0, 0, 0}, r2 = 0;
    for (int b = 0; b < D; b++) {
      d[b] = ki[b] - kj[b];
      r2 += d[b] * d[b];
    }
    const double fn = tensile ? crowding_of(i, static_cast<int>(j), std::sqrt(r2)) : 0.0;
    double power = 0.0;
    for (int a = 0; a < D; a++) {
      double t = 0.0;
      for (int b = 0; b < D; b++) {
        t += si[a * D + b] * d[b];
        if (tensile) t += fn * si[extra(0) + a * D + b] * d[b];
      }
      power += (uj[a] - uown[a]) * t;
    }
    sum += w * power;
  }
  return si[Str::K] * sum;
}

/* ----------------------------------------------------------------------
   virial, only on steps that ask for it
------------------------------------------------------------------------- */

template <int D>
void EulerianSweeps<D>::virial(const Particles &, const NeighborRows &list, double *six)
{
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    for (int k = 0; k < pairs.count[i]; k++) {
      const int j = pairs.j[pairs.first[i] + k];
      const Vector<D> d = separation(i, j);
      const double w = str(i)[Str::K] * str(j)[Str::K] * pairs.factor[pairs.first[i] + k];
      const double fn = opt.tensile ? crowding_of(i, j, d.norm()) : 0.0;
      Vector<D> f;
      for (int a = 0; a < D; a++) {
        f[a] = 0.0;
        for (int b = 0; b < D; b++) {
          const int ab = a * D + b;
          f[a] += w * (str(i)[ab] + str(j)[ab]) * d[b];
          if (opt.tensile) f[a] += w * fn * (str(i)[extra(0) + ab] + str(j)[extra(0) + ab]) * d[b];
        }
        f[a] -= whole_pull(i, pairs.first[i] + k) * d[a];
        if (k < pairs.nearest[i])
          f[a] += 0.5 * kin(i)[Kin::MASS] * near_weight[near_first[i] + k] *
              (da[i * D + a] - da[j * D + a]);
      }
      for (int a = 0; a < D; a++)
        for (int b = a; b < D; b++) six[VOIGT[a][b]] += 0.5 * d[a] * f[b];
    }
  }
}

}    // namespace

/* ---------------------------------------------------------------------- */

template <int D>
std::unique_ptr<Sweeps> SPHSolid::eulerian_sweeps(const Options &o, const std::vector<TypeData> &t)
{
  return std::make_unique<EulerianSweeps<D>>(o, t);
}

template std::unique_ptr<Sweeps> SPHSolid::eulerian_sweeps<2>(const Options &,
                                                              const std::vector<TypeData> &);
template std::unique_ptr<Sweeps> SPHSolid::eulerian_sweeps<3>(const Options &,
                                                              const std::vector<TypeData> &);

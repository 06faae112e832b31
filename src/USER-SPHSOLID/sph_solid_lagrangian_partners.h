/* ----------------------------------------------------------------------
   The Lagrangian frame between two neighbor lists: reference positions of rows,
   pairs and what is constant of them, and where the frame ends.  Members of
   LagrangianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LAGRANGIAN_PARTNERS_H
#define LMP_SPH_SOLID_LAGRANGIAN_PARTNERS_H

#include "sph_solid_lagrangian.h"

#include <Eigen/Eigenvalues>

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

/* ----------------------------------------------------------------------
   partners have new local indices: everything that is constant between two
   such moments
------------------------------------------------------------------------- */

template <int D>
void LagrangianSweeps<D>::pack_constants(const Particles &p, int i, double *row) const
{
  row[Kin::MASS] = p.mass[i];
  row[Kin::VOLUME] = weight_volume(p, i);
  for (int a = 0; a < D; a++) row[Kin::REFERENCE + a] = p.xref[i][a];
}

// Bodies cross a periodic box, and their reference does not: move reference positions by whole
// boxes until partners are neighbors there, too.  How many boxes two rows are to be apart follows
// from where they are now, so that it is the same from every particle that has both as partners

template <int D>
void LagrangianSweeps<D>::unwrap_references(const Particles &p, const NeighborRows &list)
{
  std::vector<char> placed(p.nall, 0);
  std::vector<int> open;
  auto place = [&](int j) {
    placed[j] = 1;
    if (j < p.nlocal) open.push_back(j);
  };
  for (int ii = 0; ii < list.inum; ii++) {
    if (!placed[list.ilist[ii]]) place(list.ilist[ii]);
    while (!open.empty()) {
      const int i = open.back();
      open.pop_back();
      for (int jj = 0; jj < list.numneigh[i]; jj++) {
        const int j = list.firstneigh[i][jj] & INDEX_MASK;
        if (placed[j]) continue;
        const Vector<D> X = reference_separation(i, j);
        for (int a = 0; a < D; a++)
          if (p.period[a] > 0.0) reference(j)[a] += p.period[a] * std::round(X[a] / p.period[a]);
        place(j);
      }
    }
  }
}

template <int D>
void LagrangianSweeps<D>::place_references(const Particles &p, const NeighborRows &list)
{
  if (p.period[0] > 0.0 || p.period[1] > 0.0 || p.period[2] > 0.0) unwrap_references(p, list);
  for (int row = p.nall; row < this->nrows; row++) {
    const int k = row - p.nall;
    images.template position<D>(k, reference(images.source_of(k)), reference(row));
  }
}

// append the nearest or the other partners of a list to row i from at on

template <int D>
int LagrangianSweeps<D>::add_pairs(const Particles &p, int i, int n, const int *list, bool nearest,
                                   int at)
{
  for (int jj = 0; jj < n; jj++) {
    const int j = list[jj] & INDEX_MASK;
    const int source = Base::source_of(j);
    const TypeData &ti = types[p.type[i]], &tj = types[p.type[source]];
    const double h = 0.5 * (ti.h + tj.h), support = 0.5 * opt.hbar * (ti.spacing + tj.spacing);
    const double r = reference_separation(i, j).norm();
    if ((r < support) != nearest || (!nearest && r >= SUPPORT * h)) continue;
    if (j >= p.nall && r < COINCIDE * h) continue;    // on the plane: its own image
    const double q = r / h;
    pairs.j[at] = j;
    pairs.factor[at] = p.vref[source] * CubicSpline<D>::gradient_factor(r, h);
    nearness[at] = q / (q * q + MU_EPSILON);
    at++;
  }
  return at;
}

template <int D>
void LagrangianSweeps<D>::new_neighbors(const Particles &p, const NeighborRows &list, double reach)
{
  Base::find_image_candidates(p, list, p.xref, reach);
  Base::size_rows(p, list);
  place_references(p, list);
  const std::size_t n = pairs.j.size();
  if (opt.hourglass > 0.0) damp.resize(n);
  nearness.resize(n);
  if (needs_correction()) near_weight.resize(n);
  B.resize(static_cast<std::size_t>(p.nlocal) * TENSOR);
  if (!viscous()) F.resize(static_cast<std::size_t>(p.nlocal) * TENSOR);
  nsum.assign(p.nlocal, 0.0);

#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads)
#endif
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
    fill_vectors(i);
    correct_row(p, i);
  }
}

// the last pair again, without weight

template <int D> void LagrangianSweeps<D>::fill_vectors(int i)
{
  const int n = pairs.count[i], last = pairs.first[i] + n - 1;
  for (int at = last + 1; at < pairs.first[i] + whole_vectors(n); at++) {
    pairs.j[at] = pairs.j[last];
    pairs.factor[at] = 0.0;
    nearness[at] = nearness[last];
  }
}

// m_j Wbar(X_ij)

template <int D> double LagrangianSweeps<D>::mass_wbar(const Particles &p, int i, int j) const
{
  const double near_i = opt.hbar * types[p.type[i]].spacing;
  const double near_j = opt.hbar * types[p.type[Base::source_of(j)]].spacing;
  return Base::wbar_mass(reference_separation(i, j).norm(), kin(j)[Kin::MASS], near_i, near_j);
}

// B_i and, for the acceleration correction, m_j Wbar(X_ij) of pairs and n_i, their sum

template <int D> void LagrangianSweeps<D>::correct_row(const Particles &p, int i)
{
  Tensor<D> M = Tensor<D>::Zero();
  for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k++) {
    const Vector<D> X = reference_separation(i, pairs.j[k]);
    M -= pairs.factor[k] * X * X.transpose();
    if (k >= pairs.first[i] + pairs.nearest[i]) continue;
    near_weight[k] = mass_wbar(p, i, pairs.j[k]);
    nsum[i] += near_weight[k];
  }
  const bool enough = M.determinant() >= DET_FALLBACK;
  const Tensor<D> inverse = enough ? Tensor<D>(M.inverse()) : Tensor<D>::Identity();
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) B[i * TENSOR + Blocks<D>::at(a, b)] = inverse(a, b);
}

// m_j Wbar of the nearest partners becomes a weight: constant until the partners have new indices

template <int D> void LagrangianSweeps<D>::near_weights(int i)
{
  const Pack n_i(str(i)[Str::NSUM]);
  const int first = pairs.first[i], end = first + pairs.nearest[i];
  for (int k = first; k < end; k += LANES) {
    const Pack n_j = pack_of([&](int m) {
      return str(pairs.j[k + m])[Str::NSUM];
    });
    const Pack w = correction_weight(opt.weights, load(&near_weight[k]), n_i, n_j);
    store(&near_weight[k], where_positive(first_lanes(end - k), w, Pack(0.0)));
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

template <int D> Tensor<D> LagrangianSweeps<D>::deformation_gradient(int i) const
{
  if (!viscous()) return tensor(&F[i * TENSOR]);
  const double J = kin(i)[Kin::MASS] / (str(i)[Str::RHO] * kin(i)[Kin::VOLUME]);
  return J * tensor(str(i) + at_C()).inverse().transpose() * tensor(&B[i * TENSOR]);
}

template <int D> double LagrangianSweeps<D>::step_factor(int i) const
{
  return std::min(1.0, std::max(STEP_STRETCH, least_stretch<D>(deformation_gradient(i))));
}

/* ----------------------------------------------------------------------
   where the frame ends: F turned over, squeezed flat, or two partners on top
   of each other
------------------------------------------------------------------------- */

template <int D> Overload LagrangianSweeps<D>::find_overload(const NeighborRows &list) const
{
  int first = list.inum;    // in the list, of those that are beyond it
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(nthreads) reduction(min : first)
#endif
  for (int ii = 0; ii < list.inum; ii++)
    if (ii < first && overload(list.ilist[ii]).kind != Overload::NONE) first = ii;
  return first < list.inum ? overload(list.ilist[first]) : Overload();
}

template <int D> Overload LagrangianSweeps<D>::overload(int i) const
{
  if (pairs.count[i] == 0) return {};
  const Tensor<D> Fi = deformation_gradient(i);
  const double J = Fi.determinant();
  if (!(J > 0.0)) return {Overload::TURNED_OVER, i, J};
  const double s = least_stretch<D>(Fi);
  if (s < LEAST_STRETCH) return {Overload::STRETCH, i, s};
  for (int k = pairs.first[i]; k < pairs.first[i] + pairs.count[i]; k++) {
    const double X2 = reference_separation(i, pairs.j[k]).squaredNorm();
    const double x2 = separation(i, pairs.j[k]).squaredNorm();
    if (x2 < LEAST_STRETCH * LEAST_STRETCH * X2) return {Overload::OVERLAP, i, std::sqrt(x2 / X2)};
  }
  return {};
}

template <int D> double LagrangianSweeps<D>::memory_usage() const
{
  const std::size_t doubles =
      nearness.capacity() + B.capacity() + F.capacity() + nsum.capacity() + damp.capacity();
  return Base::memory_usage() + static_cast<double>(doubles * sizeof(double));
}

}    // namespace

#endif

/* ----------------------------------------------------------------------
   A body of particles without LAMMPS: its arrays, full neighbor lists by
   comparing all pairs, and one force evaluation.

   In the Lagrangian frame the lists hold the partners in the reference
   configuration, which is the one that refer() saw.  There, a body can be
   periodic: ghosts are then made, as LAMMPS does.

   Units of the tests: rho0 = C = spacing = 1.
------------------------------------------------------------------------- */

#ifndef SPH_SOLID_TEST_CLOUD_H
#define SPH_SOLID_TEST_CLOUD_H

#include "sph_solid_sweeps.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace SPHSolid {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// every viscosity, and its name in the names of tests

constexpr Viscosity VISCOSITIES[] = {Viscosity::NONE,    Viscosity::MONAGHAN, Viscosity::CORRECT,
                                     Viscosity::LIMITED, Viscosity::BALSARA,  Viscosity::FRONT};

inline std::string name_of(Viscosity v)
{
  static const char *const names[] = {"None", "Monaghan", "Correct", "Limited", "Balsara", "Front"};
  return names[static_cast<int>(v)];
}

// largest relative error of a kernel gradient: sums over pairs keep them in single precision, of
// which B, forces and heat all take the same

constexpr double SINGLE = 0x1p-24;
// and found in it, with a few roundings each
constexpr double KERNEL_ERROR = 4.0 * SINGLE;

// numbers in [-1,1], the same everywhere

class Noise {
 public:
  explicit Noise(int seed) : engine(seed) {}
  double operator()() { return 2.0 * (engine() >> 11) / 9007199254740992.0 - 1.0; }
  Vector3d vector(int dim) { return {(*this)(), (*this)(), dim == 3 ? (*this)() : 0.0}; }

 private:
  std::mt19937_64 engine;
};

// the iron of Shaw & Reid (2009) in units of its rho0 and C, mu/K = 80/101.7

inline Material test_iron()
{
  Material m;
  m.rho0 = 1.0;
  m.eos = EOS::MIE_GRUNEISEN;
  m.C = 1.0;
  m.S = 1.8;
  m.Gamma = 1.8;
  m.shear = 0.786;
  m.strength = Strength::ELASTIC;
  return m;
}

class Cloud {
 public:
  Options opt;
  Material material = test_iron();
  int dim, nthreads = 1, shuffle = 0;    // shuffle: seed of the order of neighbors
  bool wants_virial = true;
  double spacing = 1.0;
  std::vector<Plane> planes;
  std::vector<Vector3d> x, v;
  std::vector<double> mass, volume, rho, e, epl;
  std::vector<std::array<double, 6>> S;
  std::vector<Vector3d> xref;    // lagrangian
  std::vector<double> vref;
  double period = 0.0;    // lagrangian: length of the box along x, 0: not periodic
  // a second type with another smoothing length, if it is not 0, or another material, and the particles
  // of it
  double other_h = 0.0;
  std::unique_ptr<Material> other_material;
  std::vector<int> others;
  double strange_spacing = 0.0;    // of the type that has no material
  std::unique_ptr<Sweeps> sweeps;

  explicit Cloud(int dimension) : dim(dimension)
  {
    opt.h = 1.3;
    opt.frame = Frame::EULERIAN;
    opt.corrected = true;
  }

  int size() const { return static_cast<int>(x.size()); }

  void add(const Vector3d &at, const Vector3d &velocity, double cell = 1.0)
  {
    x.push_back(at);
    v.push_back(velocity);
    mass.push_back(material.rho0 * cell);
    volume.push_back(cell);
    rho.push_back(material.rho0);
    e.push_back(0.0);
    epl.push_back(0.0);
    S.push_back({});
  }

  // a square or cubic lattice, n to a side, from the origin
  void add_lattice(int nx, int ny, int nz = 1)
  {
    for (int i = 0; i < nx; i++)
      for (int j = 0; j < ny; j++)
        for (int k = 0; k < (dim == 3 ? nz : 1); k++)
          add(spacing * Vector3d(i, j, k), Vector3d::Zero(), std::pow(spacing, dim));
  }

  // jitter of positions (in spacings), of density and of everything else
  void stir(Noise &noise, double jitter = 0.25, double density = 0.05)
  {
    for (int i = 0; i < size(); i++) {
      x[i] += jitter * spacing * noise.vector(dim);
      v[i] = 0.1 * noise.vector(dim);
      rho[i] *= 1.0 + density * noise();
      e[i] = 0.01 * noise();
      for (double &s : S[i]) s = 0.02 * noise();
      S[i][2] = -S[i][0] - S[i][1];
      if (dim == 2) S[i][4] = S[i][5] = 0.0;
    }
  }

  void move(const std::function<Vector3d(Vector3d)> &velocity)
  {
    for (int i = 0; i < size(); i++) v[i] = velocity(x[i]);
  }

  // these particles are of another material, times denser and with that speed of sound
  void make_others(const std::vector<int> &which, double denser, double C)
  {
    others = which;
    other_material = std::make_unique<Material>(material);
    other_material->rho0 *= denser;
    other_material->C = C;
    other_material->shear *= denser * C * C;
    for (const int i : which) {
      mass[i] *= denser;
      rho[i] *= denser;
    }
  }

  // the present configuration becomes the reference
  void refer()
  {
    xref = x;
    vref.resize(size());
    for (int i = 0; i < size(); i++) vref[i] = mass[i] / rho[i];
  }

  void no_stress()
  {
    for (int i = 0; i < size(); i++) {
      volume[i] = mass[i] / rho[i];
      e[i] = 0.0;
      S[i] = {};
    }
  }

  // one force evaluation, as in pair style sph/solid; returns the index of a
  // particle with an unphysical state or -1
  int evaluate(double dt = 0.0)
  {
    const int bad = advance(dt);
    const Particles p = particles();
    send(Message::STRESS);
    sweeps->mirror_stress();
    if (sweeps->sweeps_for_switch()) {
      sweeps->find_switch(p, rows);
      send(Message::SWITCH);
      sweeps->mirror_switch();
    }
    sweeps->force(p, rows);
    if (!sweeps->needs_correction()) return bad;
    send(Message::VISCOUS);
    sweeps->correction(p, rows);
    return bad;
  }

  // what the sweeps have of a particle
  void set(Message what, int i, const Vector3d &value)
  {
    sweeps->unpack(what, particles(), i, value.data());
  }

  // from owners to their ghosts
  void send(Message what)
  {
    const Particles p = particles();
    std::vector<double> message(sweeps->message_size(what));
    for (int g = size(); g < p.nall; g++) {
      sweeps->pack(what, owner[g], message.data());
      sweeps->unpack(what, p, g, message.data());
    }
  }

  // neighbor lists and the gradient sweep only
  int advance(double dt)
  {
    if (lagrangian() && xref.empty()) refer();
    find_ghosts();
    find_neighbors();
    rho_weight = rho;
    force.assign(3 * size(), 0.0);
    std::vector<TypeData> types = {TypeData(), {material, opt.h, spacing}};
    types[0].spacing = strange_spacing;
    if (other_h > 0.0 || other_material)
      types.push_back(
          {other_material ? *other_material : material, other_h > 0.0 ? other_h : opt.h, spacing});
    sweeps = Sweeps::create(dim, opt, types);
    sweeps->nthreads = nthreads;
    sweeps->wants_virial = wants_virial;
    sweeps->images.set_planes(planes);
    const Particles p = particles();
    Likeness likeness;
    for (int i = 0; lagrangian() && i < size(); i++)
      likeness.add(types[p.type[i]], p.mass[i], p.vref[i]);
    sweeps->unlike = likeness.unlike(opt);
    sweeps->new_neighbors(p, rows, 2.0 * largest_h());
    sweeps->pack_kinematics(p, pv.data());
    return sweeps->gradient(p, rows, dt);
  }

  // after the sweep that finds the weights of the correction, where they are not constant
  void forget_forces() { std::fill(force.begin(), force.end(), 0.0); }

  // energy per time given to each particle while all move with u
  std::vector<double> heat(const std::vector<Vector3d> &u)
  {
    std::vector<double> out(size(), 0.0);
    give_heat(u, out.data());
    return out;
  }
  // the same added to their energies and to the ledger
  void add_heat(const std::vector<Vector3d> &u) { give_heat(u, nullptr); }

  Vector3d f(int i) const { return {force[3 * i], force[3 * i + 1], force[3 * i + 2]}; }

  // pointers into the arrays, valid until particles are added.  Ghosts differ from
  // their owners in the position, and have a density of their own
  Particles particles()
  {
    if (owner.size() < x.size()) find_ghosts();
    const int n = size(), nall = static_cast<int>(owner.size());
    px.resize(nall);
    pv.resize(nall);
    pf.resize(nall);
    ps.resize(nall);
    pxref.resize(nall);
    type.assign(nall, 1);
    for (const int i : others) type[i] = 2;
    rho.resize(nall);
    rho_weight.resize(nall);
    all_mass.resize(nall);
    all_vref.resize(nall);
    for (int i = 0; i < nall; i++) {
      const int from = owner[i];
      px[i] = i < n ? x[i].data() : ghost_x[i - n].data();
      pv[i] = v[from].data();
      pf[i] = &force[3 * from];
      ps[i] = S[from].data();
      all_mass[i] = mass[from];
      if (!lagrangian()) continue;
      pxref[i] = xref[from].data();
      all_vref[i] = vref[from];
    }
    Particles p;
    p.nlocal = n;
    p.nall = nall;
    p.x = px.data();
    p.v = pv.data();
    p.f = pf.data();
    p.type = type.data();
    p.mass = all_mass.data();
    p.volume = volume.data();
    p.rho = rho.data();
    p.e = e.data();
    p.stress = ps.data();
    p.epl = epl.data();
    p.rho_weight = rho_weight.data();
    if (lagrangian()) {
      p.xref = pxref.data();
      p.vref = all_vref.data();
      p.period[0] = period;
    }
    return p;
  }

  const NeighborRows &neighbors() const { return rows; }
  const std::vector<int> &list(int i) const { return lists[i]; }

 private:
  std::vector<double> force, rho_weight, all_mass, all_vref;
  std::vector<double *> px, pv, pf, ps, pxref;
  std::vector<int> type, ilist, numneigh, owner;    // owner: of own particles and ghosts
  std::vector<Vector3d> ghost_x;
  std::vector<int *> firstneigh;
  std::vector<std::vector<int>> lists;
  NeighborRows rows;

  void give_heat(const std::vector<Vector3d> &u, double *out)
  {
    std::vector<const double *> of_own;
    for (const Vector3d &one : u) of_own.push_back(one.data());
    sweeps->displace(of_own.data());
    send(Message::DISPLACEMENT);
    sweeps->heat(particles(), rows, 1.0, out);
  }

  double largest_h() const { return std::max(opt.h, other_h); }
  bool lagrangian() const { return opt.frame == Frame::LAGRANGIAN; }

  // one copy of everything on either side
  void find_ghosts()
  {
    owner.resize(size());
    ghost_x.clear();
    for (int i = 0; i < size(); i++) owner[i] = i;
    if (period == 0.0) return;
    for (double shift : {-period, period})
      for (int i = 0; i < size(); i++) {
        owner.push_back(i);
        ghost_x.push_back(x[i] + Vector3d(shift, 0.0, 0.0));
      }
  }

  // lagrangian: the partner is that copy of it which is nearest now
  void find_neighbors()
  {
    const double cut = std::max(2.0 * largest_h(), opt.hbar * spacing);
    const std::vector<Vector3d> &from = lagrangian() ? xref : x;
    lists.assign(size(), {});
    for (int i = 0; i < size(); i++)
      for (int j = 0; j < size(); j++) {
        Vector3d d = from[i] - from[j];
        if (period > 0.0) d[0] -= period * std::round(d[0] / period);
        if (i == j || d.norm() >= cut) continue;
        const double shift = period > 0.0 ? std::round((x[i] - x[j])[0] / period) : 0.0;
        lists[i].push_back(shift == 0.0 ? j : j + (shift < 0.0 ? 1 : 2) * size());
      }
    if (shuffle)
      for (auto &l : lists) std::shuffle(l.begin(), l.end(), std::mt19937(shuffle));
    ilist.resize(size());
    numneigh.resize(size());
    firstneigh.resize(size());
    for (int i = 0; i < size(); i++) {
      ilist[i] = i;
      numneigh[i] = static_cast<int>(lists[i].size());
      firstneigh[i] = lists[i].data();
    }
    rows = {size(), ilist.data(), numneigh.data(), firstneigh.data()};
  }
};

// 196 particles in two dimensions, 125 in three; 25 % jitter, 5 % of density

inline Cloud random_cloud(int dim, int seed = 1)
{
  Cloud c(dim);
  if (dim == 2)
    c.add_lattice(14, 14);
  else
    c.add_lattice(5, 5, 5);
  Noise noise(seed);
  c.stir(noise);
  return c;
}

// an undisturbed lattice, n to a side, and its middle particle where n is odd

inline Cloud lattice(int dim, int n)
{
  Cloud c(dim);
  c.add_lattice(n, n, n);
  return c;
}

inline int middle(const Cloud &c)
{
  return c.size() / 2;
}

// a round body, which has no corners

inline Cloud disc()
{
  Cloud c(2);
  for (int i = -6; i <= 6; i++)
    for (int j = -6; j <= 6; j++)
      if (i * i + j * j <= 40) c.add(Vector3d(i, j, 0), Vector3d::Zero());
  Noise noise(3);
  c.stir(noise, 0.1);
  return c;
}

// two particles on the x axis that approach each other with a speed of 0.2

inline Cloud closing_pair(double distance, int dim = 2)
{
  Cloud c(dim);
  c.add({0, 0, 0}, {0.1, 0, 0});
  c.add({distance, 0, 0}, {-0.1, 0, 0});
  return c;
}

// the tensor of xx, yy, zz, xy, xz, yz, and back

inline Matrix3d symmetric(const double *s)
{
  Matrix3d t;
  t << s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2];
  return t;
}

inline std::array<double, 6> components(const Matrix3d &t)
{
  return {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(0, 2), t(1, 2)};
}

}    // namespace SPHSolid

#endif

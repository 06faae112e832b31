/* ----------------------------------------------------------------------
   A free square of 20 x 20 particles spins once around itself.

   A rigid rotation deforms nothing: kinetic energy and angular momentum stay,
   and the only stress is the one that holds the square together against its
   centrifugal force, of the order of rho v^2 at the corners.  The sums of
   `gradient plain` do not see a linear velocity field as linear near a face:
   they strain the square until it stops.
------------------------------------------------------------------------- */

#include "session.h"

using namespace sphsolid_test;

namespace {

constexpr int N = 20;
constexpr double DX = 0.38e-3, TIP = 25.0;
constexpr double CORNER = 0.5 * (N - 1) * DX * M_SQRT2;    // distance of a corner particle, m
constexpr double OMEGA = TIP / CORNER;                     // 1/s
constexpr double TURN = 2.0 * M_PI / OMEGA;                // s

struct Motion {
  double kinetic = 0.0, elastic = 0.0, angular = 0.0, angle = 0.0, total = 0.0;
};

// energies and angular momentum about the center of mass; angle of the line
// through the first and the last particle, which are opposite corners

Motion motion_of(Session &s)
{
  const State all = s.state();
  Motion m;
  for (const Particle &p : all) {
    m.kinetic += 0.5 * p.mass * (p.v[0] * p.v[0] + p.v[1] * p.v[1]);
    m.angular += p.mass * (p.x[0] * p.v[1] - p.x[1] * p.v[0]);
  }
  const Particle &a = all.front(), &b = all.back();
  m.angle = std::atan2(b.x[1] - a.x[1], b.x[0] - a.x[0]);
  m.elastic = s.value("c_energy[3]");
  m.total = s.value("c_energy");
  return m;
}

std::string square(const std::string &options, const std::string &frame = "eulerian")
{
  const double edge = 0.5 * (N - 1) * DX;
  std::ostringstream in;
  in << "units si\n"
     << "dimension 2\n"
     << "boundary f f p\n"
     << "atom_style sph/solid\n"
     << "atom_modify map array\n"
     << "region box block -0.01 0.01 -0.01 0.01 -0.0001 0.0001\n"
     << "create_box 1 box\n"
     << "lattice sq " << num(DX) << " origin 0.5 0.5 0\n"
     << "region body block " << num(-edge - 0.1 * DX) << " " << num(edge + 0.1 * DX) << " "
     << num(-edge - 0.1 * DX) << " " << num(edge + 0.1 * DX) << " INF INF units box\n"
     << "create_atoms 1 region body\n"
     << "set group all volume " << num(DX * DX) << "\n"
     << "pair_style sph/solid " << num(1.5 * DX) << " frame " << frame << " " << options << "\n"
     << "pair_coeff * * " << IRON << "neighbor " << num(0.3 * DX) << " bin\n"
     << "neigh_modify every 1 delay 0 check yes\n"
     << "variable vx atom -" << num(OMEGA) << "*y\n"
     << "variable vy atom " << num(OMEGA) << "*x\n"
     << "velocity all set v_vx v_vy NULL units box\n"
     << "fix move all sph/solid\n"
     << "fix step all sph/solid/dt 10 0.3\n"
     << "compute energy all sph/solid/energy\n"
     << "compute stress all sph/solid/atom vonmises epl\n"
     << "compute largest all reduce max c_stress[1] c_stress[2]\n"
     << "thermo_style custom step time c_energy c_largest[1]\n"
     << "run 0\n";
  return in.str();
}

// run up to a time.  The session has a variable "now"

void until(Session &s, double time)
{
  s("fix stop all halt 1 v_now >= " + num(time) +
    " error continue message no\nrun 1000000\n"
    "unfix stop\n");
}

// the largest change of what should stay, over the first, and the largest stress, seen
// at every sixteenth of a turn

struct Drift {
  double kinetic = 0.0, mechanical = 0.0, angular = 0.0, total = 0.0, stress = 0.0;
};

Drift turn_once(Session &s)
{
  auto grow = [](double &most, double now, double first) {
    const double change = std::fabs(now / first - 1.0);
    if (!(change <= most)) most = change;    // also where it is not a number
  };
  const Motion start = motion_of(s);
  Drift drift;
  for (int k = 1; k <= 16; k++) {
    until(s, k * TURN / 16);
    const Motion now = motion_of(s);
    grow(drift.kinetic, now.kinetic, start.kinetic);
    grow(drift.mechanical, now.kinetic + now.elastic, start.kinetic);
    grow(drift.angular, now.angular, start.angular);
    grow(drift.total, now.total, start.total);
    drift.stress = std::max(drift.stress, s.value("c_largest[1]"));
  }
  return drift;
}

}    // namespace

TEST(Rotation, RevolutionWithCorrectedGradient)
{
  Session s;
  s(square("gradient corrected viscosity correct") + "variable now equal time\n");
  ASSERT_EQ(s.lmp->atom->nlocal, N * N);
  const Motion start = motion_of(s);

  const Drift drift = turn_once(s);
  // measured: kinetic energy 1.7e-5, angular momentum 1.4e-8, total energy 2e-15, stress 0.39.  Limits of five
  // times the first two leave room for steps of slightly different lengths
  EXPECT_LT(drift.kinetic, 8.5e-5);
  EXPECT_LT(drift.angular, 7.0e-8);
  EXPECT_LT(drift.total, 1.0e-12);

  // the disc inside the square, of radius R = TIP/OMEGA/sqrt(2), has in its center (plane strain,
  // from the classical rotating disc)
  //   srr = stt = (3 - 2 nu)/(8 (1 - nu)) rho w^2 R^2, szz = 2 nu srr: von Mises (1 - 2 nu) srr.
  // A square that starts to spin suddenly swings around such a state, to about twice of it, and is
  // stressed more near the middle of its sides: some of rho v^2 of the corners, but less than it
  const double K = RHO0 * C0 * C0, nu = (3.0 * K - 2.0 * MU) / (6.0 * K + 2.0 * MU);
  const double disc = (3.0 - 2.0 * nu) / (8.0 * (1.0 - nu)) * 0.5 * (1.0 - 2.0 * nu);
  const double largest = drift.stress / (RHO0 * TIP * TIP);
  EXPECT_GT(largest, disc);
  EXPECT_LT(largest, 1.0);
  EXPECT_EQ(s.value("c_largest[2]"), 0.0);    // nothing yields

  // and it has turned: one whole turn ends where it began, up to the last step
  const double slack = OMEGA * s.lmp->update->dt;
  EXPECT_NEAR(motion_of(s).angle, start.angle, 1.1 * slack);
}

TEST(Rotation, PlainGradientStops)
{
  Session s;
  s(square("gradient plain viscosity correct") + "variable now equal time\n");
  const Motion start = motion_of(s);
  const double total = start.total;
  double angular = start.angular;
  for (int k = 1; k <= 16; k++) {
    until(s, k * TURN / 16);
    angular = std::min(angular, motion_of(s).angular);
  }
  // measured: kinetic energy 0.006 of the first after the revolution, angular momentum down to -0.43
  // of the first on the way, von Mises stress at the yield stress, total energy kept to 2e-14
  const Motion end = motion_of(s);
  EXPECT_LT(end.kinetic / start.kinetic, 0.05);
  EXPECT_LT(angular, 0.0);    // it even turns back
  EXPECT_GT(s.value("c_largest[1]"), 50.0 * RHO0 * TIP * TIP);
  EXPECT_GT(s.value("c_largest[2]"), 0.0);
  EXPECT_NEAR(end.total / total, 1.0, 1.0e-11);    // what is lost is strain and heat
}

// The Lagrangian frame, without anything that dissipates, with forces along the
// pairs only, and with its defaults.  A square that starts to spin without the
// stress that holds it together swings: of its kinetic energy a share of the order
// of rho v^2/E is strain, which comes and goes.  Both together are constant where
// nothing dissipates, but for what velocity Verlet does to an oscillation of the
// square, (w dt)^2 of that share.  Only the acceleration correction is not central:
// with the defaults angular momentum misses the 1e-9 of the other forms
//
// measured: kinetic energy, angular momentum, kinetic and elastic energy, total energy
//   none, hourglass 0          1.8e-5   4e-15   1.4e-8   4e-15
//   limited, hourglass 0.03    1.5e-5   3e-15   4.3e-6   3e-15
//   defaults                   1.7e-5   6.2e-8   2.6e-6   5e-15

TEST(Rotation, RevolutionInTheLagrangianFrame)
{
  const double K = RHO0 * C0 * C0, E = 9.0 * K * MU / (3.0 * K + MU);
  const double share = RHO0 * TIP * TIP / E;
  const double w_dt = 0.3 * 1.5 * M_PI / N;    // Courant number 0.3 at h = 1.5 spacings
  struct Case {
    std::string options;
    double angular, mechanical;
  };
  for (const Case &c : {Case{"viscosity none hourglass 0", 1.0e-13, w_dt * w_dt * share},
                        Case{"viscosity limited 0.5 0.5 hourglass 0.03", 1.0e-13, share},
                        Case{"", 1.0e-7, share}}) {
    Session s;
    s(square(c.options, "lagrangian") + "variable now equal time\n");
    ASSERT_EQ(s.lmp->atom->nlocal, N * N);
    const Motion start = motion_of(s);
    const Drift drift = turn_once(s);
    EXPECT_LT(drift.kinetic, share) << c.options;
    EXPECT_LT(drift.angular, c.angular) << c.options;
    EXPECT_LT(drift.mechanical, c.mechanical) << c.options;
    EXPECT_LT(drift.total, 1.0e-12) << c.options;
    EXPECT_NEAR(motion_of(s).angle, start.angle, 1.1 * OMEGA * s.lmp->update->dt);
  }
}

/* ----------------------------------------------------------------------
   Three dimensions, units of the lattice.  A cube of 6 x 6 x 6 particles with half cells on its faces,
   as examples have it: its corners have an eighth of a cell, and partners on one side only
------------------------------------------------------------------------- */

namespace {

constexpr double SPIN = 0.01;

// n particles along each axis; faces: the share of a cell that a particle on a face has

std::string spinning(int nx, int ny, int nz, double faces, const std::string &options)
{
  std::ostringstream in;
  in << "units lj\n"
     << "dimension 3\n"
     << "boundary f f f\n"
     << "atom_style sph/solid\n"
     << "lattice sc 1.0\n"
     << "region box block -10 10 -10 10 -10 10\n"
     << "create_box 1 box\n"
     << "region body block 0 " << nx - 0.5 << " 0 " << ny - 0.5 << " 0 " << nz - 0.5 << "\n"
     << "create_atoms 1 region body\n";
  const int n[3] = {nx, ny, nz};
  for (int k = 0; k < 3; k++)
    in << "variable cell" << k << " atom 1-" << num(1.0 - faces) << "*(("
       << "xyz"[k] << "<0.5)||("
       << "xyz"[k] << ">" << n[k] - 1.5 << "))\n";
  in << "variable cell atom v_cell0*v_cell1*v_cell2\n"
     << "set group all volume v_cell\n"
     << "pair_style sph/solid 1.0 " << options << "\n"
     << "pair_coeff * * inline rho0 1 eos linear 1 shear 0.4 strength elastic\n"
     << "variable vx atom -" << num(SPIN) << "*(y-" << 0.5 * (ny - 1) << ")\n"
     << "variable vy atom " << num(SPIN) << "*(x-" << 0.5 * (nx - 1) << ")\n"
     << "velocity all set v_vx v_vy 0\n"
     << "fix move all sph/solid\n"
     << "fix step all sph/solid/dt 10 0.5\n";
  return in.str();
}

// the largest change of the angular momentum in an eighth of a turn, over the first

double lost_momentum(Session &s)
{
  s("variable now equal time\nrun 0");
  const double first = s.value("angmom(all,z)");
  double most = 0.0;
  for (int k = 1; k <= 8; k++) {
    until(s, k * M_PI / (32.0 * SPIN));
    most = std::max(most, std::fabs(s.value("angmom(all,z)") / first - 1.0));
  }
  return most;
}

}    // namespace

// measured: rounding without viscosity, 3.5e-7 with the acceleration correction, whose forces are not
// central.  When corners had no gradient correction, since their det M is small, it was 0.036 and grew

TEST(Rotation, CubeWithHalfCellsKeepsAngularMomentum)
{
  struct Case {
    std::string options;
    double most;
  };
  for (const Case &c :
       {Case{"viscosity none hourglass 0", 1.0e-12}, Case{"viscosity correct", 1.0e-6}}) {
    Session s;
    s(spinning(6, 6, 6, 0.5, c.options));
    EXPECT_LT(lost_momentum(s), c.most) << c.options;
    EXPECT_THAT(s.log(), Not(HasSubstr("no gradient correction")));
  }
}

// a row has no deformation across itself that partners could tell: it stays uncorrected, is tied to the
// axes of the laboratory, and its log says that there are such particles

TEST(Rotation, RowIsTiedToTheLaboratory)
{
  Session s;
  s(spinning(8, 1, 1, 1.0, "viscosity none hourglass 0"));
  EXPECT_GT(lost_momentum(s), 0.1);
  EXPECT_THAT(s.log(), HasSubstr("no gradient correction for 8 particles"));
}

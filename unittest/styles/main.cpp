/* ----------------------------------------------------------------------
   main() of the tests that run LAMMPS: MPI around GoogleTest, output of
   rank 0 only, failure if any rank failed.
------------------------------------------------------------------------- */

#include <gtest/gtest.h>

#include <cstdlib>
#include <mpi.h>

int main(int argc, char **argv)
{
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();    // while building: without MPI

  unsetenv("OMP_NUM_THREADS");    // one thread, whatever the environment says
  setenv("LAMMPS_POTENTIALS", SPHSOLID_TEST_ROOT "/potentials", 1);    // material cards by name
  MPI_Init(&argc, &argv);
  int me;
  MPI_Comm_rank(MPI_COMM_WORLD, &me);
  auto &listeners = testing::UnitTest::GetInstance()->listeners();
  if (me != 0) delete listeners.Release(listeners.default_result_printer());
  int mine = RUN_ALL_TESTS(), any = 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return any;
}

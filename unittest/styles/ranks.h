/* ----------------------------------------------------------------------
   Tests on several ranks, started by mpiexec: what one rank tells the others.
------------------------------------------------------------------------- */

#ifndef SPHSOLID_TEST_RANKS_H
#define SPHSOLID_TEST_RANKS_H

#include "session.h"

namespace sphsolid_test {

inline bool first_rank(MPI_Comm comm = MPI_COMM_WORLD)
{
  int me;
  MPI_Comm_rank(comm, &me);
  return me == 0;
}

inline int ranks()
{
  int n;
  MPI_Comm_size(MPI_COMM_WORLD, &n);
  return n;
}

// broadcast; who waits sleeps, since tests may run on fewer cores than ranks

inline void share(void *data, int bytes, MPI_Comm comm = MPI_COMM_WORLD)
{
  MPI_Request request;
  MPI_Ibcast(data, bytes, MPI_BYTE, 0, comm, &request);
  for (int done = 0; !done;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (!done) usleep(1000);
  }
}

inline void share(State &state)
{
  int n = static_cast<int>(state.size());
  share(&n, sizeof(n));
  state.resize(n);
  share(state.data(), n * static_cast<int>(sizeof(Particle)));
}

// a file in the folder of the first rank

inline std::string shared_file(const std::string &name, MPI_Comm comm = MPI_COMM_WORLD)
{
  char path[512] = "";
  snprintf(path, sizeof(path), "%s", file(name).c_str());
  share(path, sizeof(path), comm);
  return path;
}

// the state after a run of the first rank alone

inline State alone(const std::string &script)
{
  State state;
  if (first_rank()) {
    Session s(MPI_COMM_SELF);
    s(script);
    state = s.state();
  }
  share(state);
  return state;
}

// the run, and that every rank had something to do

inline State together(const std::string &script)
{
  Session s;
  s(script);
  EXPECT_GT(s.lmp->atom->nlocal, 0);
  return s.state();
}

}    // namespace sphsolid_test

#endif

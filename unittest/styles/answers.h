/* ----------------------------------------------------------------------
   Words of input and what LAMMPS has to answer, for tests of every keyword
   and of the message for every wrong value.
------------------------------------------------------------------------- */

#ifndef SPHSOLID_TEST_ANSWERS_H
#define SPHSOLID_TEST_ANSWERS_H

#include "session.h"

namespace sphsolid_test {

struct Case {
  std::string name, input, message;
};

inline std::string name_of(const testing::TestParamInfo<Case> &info)
{
  return info.param.name;
}

}    // namespace sphsolid_test

#endif

/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   Copyright (2003) Sandia Corporation.  Under the terms of Contract
   DE-AC04-94AL85000 with Sandia Corporation, the U.S. Government retains
   certain rights in this software.  This software is distributed under
   the GNU General Public License.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Which bodies the particles of a reference form: those that partners join, directly or through others

#include "fix_sph_solid_partners.h"

#include "atom.h"
#include "comm.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

using namespace LAMMPS_NS;

namespace {

// sets that grow together: each has one of its members as root

class Sets {
 public:
  explicit Sets(int n) : parent(n) { std::iota(parent.begin(), parent.end(), 0); }
  int root(int i)
  {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  void join(int i, int j)
  {
    i = root(i);
    j = root(j);
    parent[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<int> parent;
};

}    // namespace

/* ----------------------------------------------------------------------
   on each rank first, then across ranks: of a pair with a partner elsewhere the body here
   is named by the ID of one of its particles, and so is, by the rank that has the partner, the
   body there
------------------------------------------------------------------------- */

FixSPHSolidPartners::Bodies FixSPHSolidPartners::bodies() const
{
  const tagint *tag = atom->tag;
  const int *type = atom->type;
  Sets here(atom->nlocal);
  bigint mixed = 0;
  std::vector<std::pair<int, tagint>> cut;    // own particle, ID of its partner elsewhere
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < npartner[i]; k++) {
      const int j = where(partner[i][k]);    // an own particle rather than its image
      if (j >= 0 && type[j] != type[i]) mixed++;
      if (j >= 0 && j < atom->nlocal)
        here.join(i, j);
      else
        cut.emplace_back(i, partner[i][k]);
    }

  std::set<std::pair<tagint, tagint>> names;    // of a body here, ID of a particle elsewhere
  for (const auto &pair : cut) names.emplace(tag[here.root(pair.first)], pair.second);
  std::vector<tagint> pairs;
  for (const auto &pair : names) pairs.insert(pairs.end(), {pair.first, pair.second});
  std::vector<tagint> same;    // two names of one body
  const std::vector<tagint> all_pairs = of_all_ranks(pairs);
  for (std::size_t k = 0; k < all_pairs.size(); k += 2) {
    const int j = where_own(all_pairs[k + 1]);
    if (j >= 0) same.insert(same.end(), {all_pairs[k], tag[here.root(j)]});
  }

  std::map<tagint, bigint> sizes;
  for (int i = 0; i < atom->nlocal; i++)
    if (npartner[i] >= 0) sizes[tag[here.root(i)]]++;
  return joined(sizes, of_all_ranks(same), mixed);
}

// sizes: of the parts of bodies that lie here; same: names of parts that belong to one body, in pairs

FixSPHSolidPartners::Bodies FixSPHSolidPartners::joined(const std::map<tagint, bigint> &sizes,
                                                        const std::vector<tagint> &same,
                                                        bigint mixed) const
{
  std::vector<tagint> mine;
  for (const auto &part : sizes)
    mine.insert(mine.end(), {part.first, static_cast<tagint>(part.second)});
  const std::vector<tagint> parts = of_all_ranks(mine);
  std::map<tagint, int> number;
  for (std::size_t k = 0; k < parts.size(); k += 2)
    number.emplace(parts[k], static_cast<int>(k / 2));
  Sets everywhere(static_cast<int>(number.size()));
  for (std::size_t k = 0; k < same.size(); k += 2)
    everywhere.join(number.at(same[k]), number.at(same[k + 1]));

  std::map<int, bigint> together;
  for (std::size_t k = 0; k < parts.size(); k += 2)
    together[everywhere.root(number.at(parts[k]))] += parts[k + 1];
  Bodies out;
  for (const auto &body : together) out.sizes.push_back(body.second);
  std::sort(out.sizes.rbegin(), out.sizes.rend());
  MPI_Allreduce(&mixed, &out.mixed_pairs, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  out.mixed_pairs /= 2;
  return out;
}

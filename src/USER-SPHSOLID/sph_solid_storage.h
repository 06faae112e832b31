/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   Copyright (2003) Sandia Corporation.  Under the terms of Contract
   DE-AC04-94AL85000 with Sandia Corporation, the U.S. Government retains
   certain rights in this software.  This software is distributed under
   the GNU General Public License.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

/* ----------------------------------------------------------------------
   Memory of the sweeps: arrays that begin on cache lines, room that is not set to 0, and
   what is asked for before it is read.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_STORAGE_H
#define LMP_SPH_SOLID_STORAGE_H

#include <cstddef>
#include <new>
#include <vector>

namespace SPHSolid {

// n numbers that will be wanted soon: sweeps read more arrays side by side than the processor
// follows by itself, and it stops at the end of every page.  Nothing happens behind the end of
// an array.  The empty assembly is why calls stay: GCC takes a function that does nothing but ask
// ahead for one without any effect, and leaves out who calls it

template <class T> inline void prefetch(const T *from, int n)
{
#if defined(__GNUC__)
  asm volatile("");
  for (int k = 0; k < n; k += static_cast<int>(64 / sizeof(T))) __builtin_prefetch(from + k);
#endif
}

// the same of n that begin anywhere in a cache line

template <class T> inline void prefetch_list(const T *from, int n)
{
  prefetch(from, n + static_cast<int>(64 / sizeof(T)) - 1);
}

// arrays of rows that begin on a cache line

template <class T> struct CacheAligned {
  typedef T value_type;
  CacheAligned() = default;
  template <class U> CacheAligned(const CacheAligned<U> &) {}
  static constexpr std::align_val_t LINE{64};
  T *allocate(std::size_t n) { return static_cast<T *>(::operator new(n * sizeof(T), LINE)); }
  void deallocate(T *p, std::size_t) { ::operator delete(p, LINE); }
};
template <class T, class U> inline bool operator==(CacheAligned<T>, CacheAligned<U>)
{
  return true;
}
template <class T, class U> inline bool operator!=(CacheAligned<T>, CacheAligned<U>)
{
  return false;
}

template <class T> using AlignedRows = std::vector<T, CacheAligned<T>>;
using SingleRows = AlignedRows<float>;

// room of which as much is taken from the system as something is written to: not set to 0

template <class T> struct Untouched : CacheAligned<T> {
  Untouched() = default;
  template <class U> Untouched(const Untouched<U> &) {}
  template <class U> struct rebind {
    typedef Untouched<U> other;
  };
  template <class U> void construct(U *at) { ::new (static_cast<void *>(at)) U; }
};
template <class T> using Room = std::vector<T, Untouched<T>>;

// for n at least, with nothing in it; some more, so that it is not made anew each time

template <class T> inline void make_room(Room<T> &room, std::size_t n)
{
  if (room.size() >= n) return;
  Room<T>().swap(room);
  room.resize(n + n / 10);
}

}    // namespace SPHSolid

#endif

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
   The LAMMPS versions that this package supports, 4 Feb 2025 to 4 Jul 2026, and
   the place for what differs between them: nothing yet.  SPHSOLID_LMP_VERSION (YYYYMMDD) is
   taken from LAMMPS's version.h by the build system.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_COMPAT_H
#define LMP_SPH_SOLID_COMPAT_H

#ifndef SPHSOLID_LMP_VERSION
#error "SPHSOLID_LMP_VERSION is not set: build through cmake/USER-SPHSOLID.cmake"
#endif

#if SPHSOLID_LMP_VERSION < 20250204
#error "USER-SPHSOLID needs LAMMPS 4 Feb 2025 or newer"
#endif

#endif

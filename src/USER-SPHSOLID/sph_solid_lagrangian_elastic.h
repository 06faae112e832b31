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
   The Lagrangian frame: stress and forces of small displacements about the
   reference, linear and elastic.  Members of LagrangianSweeps.
------------------------------------------------------------------------- */

#ifndef LMP_SPH_SOLID_LAGRANGIAN_ELASTIC_H
#define LMP_SPH_SOLID_LAGRANGIAN_ELASTIC_H

#include "sph_solid_lagrangian.h"

namespace {

// Hooke's law, with F = 1 and so C = B^T

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::elastic_stress(const Particles &p)
{
  mirror_vectors(V);
  each_block([&](int block, const Batch &batch, Totals &) {
    const Tensors correction = load_correction(block);
    const Tensors gradient = accumulate(block).velocity * correction;
    const Pack shear = Base::shear_moduli(p, batch);
    const Pack bulk = Base::of_types(p, batch, [this](int t) {
      return types[t].material.bulk_modulus();
    });
    const Pack pressure = (bulk - (2.0 / 3.0) * shear) * gradient.trace();
    const Tensors sigma =
        shear * Tensors(gradient + gradient.transpose()) + pressure * Tensors::Identity();
    const int column = block * LANES;
    store_tensor(column, T, sigma * correction.transpose());
    columns.copy_to_rows(column, T, T + D * D);
  });
}

template <int D, class Precision>
void LagrangianSweeps<D, Precision>::elastic_force(const Particles &p)
{
  const bool keeps = this->keeps_heat;
  this->keeps_heat = false;
  force_blocks<PairForm::NONE, false>(p);
  this->keeps_heat = keeps;
}

}    // namespace

#endif

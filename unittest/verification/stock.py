"""Why the styles that come with LAMMPS cannot run a scene, as found in LAMMPS 4 Jul 2026. For cannot(method) in scene.py."""

NO_PERIODIC = ("its forces across a periodic boundary are wrong (pair_smd_tlsph.cpp takes the minimum image of a "
               "reference distance before it computes it): the first step tears the strip apart")
NO_MIE_GRUNEISEN = "its equations of state are linear, Tait and perfect gas: no Mie-Gruneisen"
NO_WALL = "it has no rigid wall that acts on the face of a solid"
NO_SOLID = "its materials are fluids: no strength"
NO_SHEAR = "its pair styles are for fluids: no shear stress"
NO_FLUID = "its fluids are Tait's water and the ideal gas: no Mie-Gruneisen"


def plane_shock(method, fluid=False):
    """For plane waves in a periodic strip of Mie-Gruneisen solid or fluid."""
    return {"": "", "tlsph": NO_PERIODIC, "ulsph": NO_MIE_GRUNEISEN, "sph": NO_FLUID if fluid else NO_SOLID}[method.stock]


def solid_body(method):
    """For bodies that resist a change of shape."""
    return NO_SHEAR if method.stock == "sph" else ""

"""What the scenes with a plane shock share: noh, shocktube, and the two waves of piston and impact."""

# cause of a known miss
RUNS_AHEAD = "with too little viscosity the shock becomes a train of solitary waves that grow; the first runs ahead"


def calm(method):
    """So viscous that no shock overshoots."""
    return method.kind in ("monaghan1", "balsara1")


def order_gates(cases, least):
    """For the L1 error, where the viscosity is whole in the shock and the stiffness right."""
    method = cases[0].method
    return {"l1": least} if method.whole and method.gradient == "corrected" else {}

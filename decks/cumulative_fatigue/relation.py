"""The strain-life relation of the decks of Ti-6Al-4V, and growth by elements, in closed form: for plot.py of this scene and of others."""
import numpy as np

YOUNG, YIELD, LENGTH = 110e9, 988e6, 1.09e-6
DUCTILITY, EXPONENT = 1.94, -0.865
LIMITS = {"254": 0.00231, "315": 0.002864}  # by the strength at 1e7 cycles, MPa
SCATTER = (0.05, 0.15, 0.01)  # of limit, ductility and exponent, as in specimens.yaml and bonds.yaml


def life(strain_range, limit=LIMITS["254"], ductility=DUCTILITY, exponent=EXPONENT, measure="Amplitude"):
    """Cycles; infinite up to the limit. strain - limit = ductility (2 N or N)^exponent."""
    reversals = 2.0 if measure == "Amplitude" else 1.0
    excess = strain_range / reversals - limit
    with np.errstate(divide="ignore"):
        return (np.maximum(excess, 0.0) / ductility) ** (1.0 / exponent) / reversals


def amplitude(cycles, limit=LIMITS["254"], ductility=DUCTILITY, exponent=EXPONENT):
    """Amplitude of the strain of a bond that lives so many cycles: the inverse of life, of half of its range."""
    return limit + ductility * (2 * cycles)**exponent


def growth(intensity_range, measure="Amplitude"):
    """da/dN in m of a range of K in Pa m^0.5: r/N of the element, its strain by Neuber's rule without hardening."""
    stress = intensity_range / np.sqrt(2 * np.pi * LENGTH)
    return LENGTH / life(stress**2 / (YOUNG * np.minimum(stress, 2 * YIELD)), measure=measure)


def lives_that_scatter(strain_range, n=200000, weakest_of=1):
    """Sorted lives of specimens, by numbers that are not those of pdrun; of the weakest of so many bonds."""
    z = np.random.default_rng(1).standard_normal((3, n))
    factors = [np.exp(deviation * normal) for deviation, normal in zip(SCATTER, z)]
    lives = np.sort(life(strain_range, LIMITS["254"] * factors[0], DUCTILITY * factors[1], EXPONENT * factors[2]))
    shares = 1 - (1 - (np.arange(n) + 0.5) / n) ** weakest_of
    return lives, shares

#!/usr/bin/python3
"""lives.csv: lives that scatter about a strain-life line, drawn once with a fixed seed; make_lives.py > lives.csv"""
import numpy as np

COEFFICIENT, EXPONENT, LIMIT, SCATTER = 426.0, 2.77, 1.86e-3, 0.3  # of bar.yaml; standard deviation of ln(life)
ranges = np.geomspace(2.2e-3, 8e-3, 8)
lives = 1 / (COEFFICIENT * (ranges - LIMIT) ** EXPONENT) * np.exp(SCATTER * np.random.default_rng(7).normal(size=8))
print("# Made by make_lives.py: the law of bar.yaml with lognormal scatter of 0.3, fully reversed strain.")
print("amplitude,cycles")
for strain, life in zip(ranges / 2, lives):
    print(f"{strain:.5g},{life:.5g}")

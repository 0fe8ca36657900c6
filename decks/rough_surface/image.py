#!/usr/bin/python3
"""Sections of rough surfaces as black and white images, in place of those of a microscope.
  image.py sine AMPLITUDE WAVELENGTH START FILE     heights AMPLITUDE cos(2 pi (x - START)/WAVELENGTH), micrometres
  image.py random SEED FILE                         heights of the spectrum below

Bright is material. Pixels of 2 um; the image goes from x = -2 mm to 2 mm and 0.08 mm to both sides of the mean height.
"""
import sys

import numpy as np
from PIL import Image

PIXEL, WIDTH, HEIGHT = 2.0, 4000.0, 160.0  # um
ROUGHNESS, SHORTEST, LONGEST = 6.0, 150.0, 1000.0  # um: root of the mean square; wavelengths


def waves(words):
    """[n] amplitudes, wave numbers (1/um) and phases: heights are the sum of amplitude cos(k x + phase)."""
    if words[0] == "sine":
        amplitude, length, start = map(float, words[1:4])
        k = 2 * np.pi / length
        return np.array([amplitude]), np.array([k]), np.array([-k * start])
    random = np.random.default_rng(int(words[1]))
    numbers = np.arange(int(np.ceil(WIDTH / LONGEST)), int(WIDTH / SHORTEST) + 1)  # waves in the length of the image
    k = 2 * np.pi * numbers / WIDTH
    amplitudes = random.rayleigh(1.0, len(k)) / k  # as many slopes of each wavelength
    amplitudes *= ROUGHNESS / np.sqrt(0.5 * np.sum(amplitudes**2))
    return amplitudes, k, random.uniform(0, 2 * np.pi, len(k))


def heights(words, x):
    return sum(a * np.cos(k * x + phase) for a, k, phase in zip(*waves(words)))


if __name__ == "__main__":
    x = (np.arange(WIDTH / PIXEL) + 0.5) * PIXEL - 0.5 * WIDTH
    y = 0.5 * HEIGHT - (np.arange(HEIGHT / PIXEL) + 0.5) * PIXEL  # the first row is on top
    Image.fromarray(np.where(y[:, None] < heights(sys.argv[1:], x), 255, 0).astype(np.uint8)).save(sys.argv[-1])

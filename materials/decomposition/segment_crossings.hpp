// How many of the connections of two cells in a plane cross a segment, without sampling of pairs.
#ifndef PD_SEGMENT_CROSSINGS_HPP
#define PD_SEGMENT_CROSSINGS_HPP

#include "discontinuities.hpp"

namespace pd::decomposition {

/// Share of the pairs of places of two cells whose connection crosses the segment from `start` to `end`; within some
/// 1e-4. Pairs that cross it at c in the direction u are p = c - r u and q = c + s u, and dp dq = (r + s) |u x dc| dr
/// ds dphi: the integrals over r and s are exact, those over the angle and over the segment by Gauss's rule, the former
/// between the corners as seen from c.
double shareAcrossSegment(const Cell& a, const Cell& b, const Place& start, const Place& end);

}  // namespace pd::decomposition

#endif

// The loops of a product with the stiffness of a spring network.
#ifndef PD_SPRING_KERNELS_HPP
#define PD_SPRING_KERNELS_HPP

#include "spring_network.hpp"

namespace pd {

// In units of the network, over owned points; what is for ghosts and images is added to theirs.

/// families += s of LinearSprings.
template <class Real>
void addSpringFamilies(const SpringNetwork& network, const PointVector<Real>& x, PointVector<Real>& families);

/// y = K x, where the families have made `responses` of their s.
template <class Real>
void springForces(const SpringNetwork& network, const PointVector<Real>& x, const PointVector<Real>& responses,
                  PointVector<Real>& y);

/// y = K0 x: of a network whose families give way (Rotation), as if they did not.
template <class Real>
void stiffSpringForces(const SpringNetwork& network, const PointVector<Real>& x, PointVector<Real>& y);

}  // namespace pd

#endif

// What a material adds its tangent to; the names of Peridigm's SerialMatrix.
#ifndef PERIDIGM_SERIALMATRIX_HPP
#define PERIDIGM_SERIALMATRIX_HPP

namespace PeridigmNS {

/// A matrix over all degrees of freedom, indexed by global degree of freedom (numDof * global id + component).
/// Contributions accumulate; rows of points that another rank owns are allowed and are sent to their owner.
class SerialMatrix {
 public:
  virtual ~SerialMatrix() = default;
  virtual void addValue(int globalRow, int globalCol, double value) = 0;
  /// Adds the dense block values[i][j] at (globalIndices[i], globalIndices[j]).
  virtual void addValues(int numIndices, const int* globalIndices, const double* const* values) = 0;
  /// As addValues, but only the entries that couple degrees of freedom of one point (3 a point).
  virtual void addBlockDiagonalValues(int numIndices, const int* globalIndices, const double* const* values) = 0;
  virtual void putScalar(double value) = 0;
};

}  // namespace PeridigmNS

#endif

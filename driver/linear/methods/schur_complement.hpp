// What a symmetric matrix, or its inverse, is to some of its unknowns, by MUMPS.
#ifndef PD_SCHUR_COMPLEMENT_HPP
#define PD_SCHUR_COMPLEMENT_HPP

#include <string>
#include <vector>

namespace pd {

/// One triangle of a symmetric matrix, by entries: unknowns counted from 1, `rows` no less than `columns`; entries of
/// one place are added.
struct SymmetricEntries {
  int size = 0;
  std::vector<int> rows, columns;
  std::vector<double> values;

  void add(int row, int column, double value) {
    rows.push_back(row > column ? row : column);
    columns.push_back(row > column ? column : row);
    values.push_back(value);
  }
};

struct SchurComplement {
  std::vector<double> values;  ///< [kept][kept]
  std::string trouble;         ///< why there is none; empty where there is
};

/// A_kk - A_ko A_oo^-1 A_ok of a positive definite matrix, k its unknowns `kept` (from 1), o the others. `order`: all
/// unknowns, from 1, as they are to be eliminated, with those that are kept last. On this rank alone.
SchurComplement schurComplement(SymmetricEntries& matrix, std::vector<int>& kept, const std::vector<int>& order);

struct InverseColumns {
  std::vector<double> values;  ///< [columns][rows]
  std::string trouble;         ///< why there are none; empty where there are
};

/// Some rows of some columns of the inverse of a positive definite matrix; unknowns from 1. `order`: all of them, as
/// they are to be eliminated. On this rank alone.
InverseColumns columnsOfInverse(SymmetricEntries& matrix, const std::vector<int>& rows, const std::vector<int>& columns,
                                const std::vector<int>& order);

}  // namespace pd

#endif

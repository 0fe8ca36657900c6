// The Tpetra types of this folder: those that Debian's libraries instantiate.
#ifndef PD_TPETRA_TYPES_HPP
#define PD_TPETRA_TYPES_HPP

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>

namespace pd::tpetra {

using Map = Tpetra::Map<int, long long>;
using Matrix = Tpetra::CrsMatrix<double, int, long long>;
using MultiVector = Tpetra::MultiVector<double, int, long long>;
using Operator = Tpetra::Operator<double, int, long long>;

}  // namespace pd::tpetra

#endif

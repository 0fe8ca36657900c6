// What compute plug-ins use of Epetra_Comm. An alias, so that it never clashes with the real class in a process
// that links Epetra for other reasons. Inside a Peridigm tree the real header is found instead.
#ifndef EPETRA_COMM_H
#define EPETRA_COMM_H

namespace PeridigmNS {

/// Reductions over all ranks. Each returns 0; `partial` and `global` must not overlap.
class Communicator {
 public:
  virtual ~Communicator() = default;
  virtual int MyPID() const = 0;
  virtual int NumProc() const = 0;
  virtual int SumAll(double* partial, double* global, int count) const = 0;
  virtual int SumAll(int* partial, int* global, int count) const = 0;
  virtual int MaxAll(double* partial, double* global, int count) const = 0;
  virtual int MaxAll(int* partial, int* global, int count) const = 0;
  virtual int MinAll(double* partial, double* global, int count) const = 0;
  virtual int MinAll(int* partial, int* global, int count) const = 0;
};

}  // namespace PeridigmNS

using Epetra_Comm = PeridigmNS::Communicator;

#endif

// Which instructions dense linear algebra uses.
#ifndef PD_BLAS_HPP
#define PD_BLAS_HPP

namespace pd {

/// OpenBLAS chooses its loops by the name of the processor, and takes those of 2004 (SSE3) for names that came after
/// it: a quarter of the speed, or less. Here what the processor can do decides then, unless OPENBLAS_CORETYPE says
/// otherwise. Other libraries are left alone. Once, before any of it is used.
void prepareBlas();

}  // namespace pd

#endif

#include "multigrid.hpp"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace pd {

namespace {

/// From the library where the build or the installation has it, which programs know as a place of their libraries.
MakeMueLu* loadMueLu() {
  void* const library = dlopen("libpd_multigrid.so", RTLD_NOW);
  void* const symbol = library != nullptr ? dlsym(library, "makeMueLu") : nullptr;
  if (symbol == nullptr)
    throw std::runtime_error(
        std::string("the library of the multigrid preconditioner, which belongs to pdrun, cannot be "
                    "loaded (another preconditioner needs none): ") +
        dlerror());
  return reinterpret_cast<MakeMueLu*>(symbol);
}

}  // namespace

Teuchos::RCP<tpetra::Operator> makeMultigrid(const Teuchos::RCP<tpetra::Matrix>& matrix, int width,
                                             const Teuchos::RCP<tpetra::MultiVector>& nullspace) {
  static MakeMueLu* const make = loadMueLu();
  Teuchos::RCP<tpetra::Operator> result;
  make(&matrix, width, &nullspace, &result);
  return result;
}

}  // namespace pd

#include "ghost_exchange.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Distributor.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>

namespace pd {

namespace {

using Map = Tpetra::Map<int, long long>;
using Import = Tpetra::Import<int, long long>;

Teuchos::RCP<const Import> makeImport(const Communicator& comm, const std::vector<int>& globalIds, int nOwned) {
  const auto teuchosComm = Teuchos::rcp(new Teuchos::MpiComm<int>(comm.mpi()));
  const std::vector<long long> overlap(globalIds.begin(), globalIds.end());
  const Teuchos::ArrayView<const long long> all(overlap.data(), static_cast<Teuchos::Ordinal>(overlap.size()));
  const auto unknownCount = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  const auto ownedMap = Teuchos::rcp(new Map(unknownCount, all.view(0, nOwned), 0, teuchosComm));
  const auto overlapMap = Teuchos::rcp(new Map(unknownCount, all, 0, teuchosComm));
  return Teuchos::rcp(new Import(ownedMap, overlapMap));
}

std::vector<int> copyOf(const Teuchos::ArrayView<const int>& view) { return {view.begin(), view.end()}; }

}  // namespace

/// Tpetra's import plans the messages. Packing is done here, so that the caller's array is read and written in place
/// and only the points at the border between ranks are touched.
struct GhostExchange::Implementation {
  Teuchos::RCP<const Import> plan;
  std::vector<int> sent;      ///< owned points that are ghosts elsewhere, in the order of the messages
  std::vector<int> received;  ///< ghosts here, in the order of the messages
  std::vector<double> sentValues, receivedValues;

  void pack(const double* values, int width, const std::vector<int>& points, std::vector<double>& buffer) {
    buffer.resize(points.size() * static_cast<std::size_t>(width));
    double* out = buffer.data();
    for (const int point : points)
      for (int k = 0; k < width; ++k) *out++ = values[static_cast<std::size_t>(point) * width + k];
  }
};

GhostExchange::GhostExchange(const Communicator& comm, const std::vector<int>& globalIds, int nOwned) {
  if (comm.size() == 1) return;
  implementation_ = std::make_unique<Implementation>();
  implementation_->plan = makeImport(comm, globalIds, nOwned);
  implementation_->sent = copyOf(implementation_->plan->getExportLIDs());
  implementation_->received = copyOf(implementation_->plan->getRemoteLIDs());
}

GhostExchange::~GhostExchange() = default;

void GhostExchange::import(double* values, int width) const {
  if (!implementation_) return;
  Implementation& self = *implementation_;
  self.pack(values, width, self.sent, self.sentValues);
  self.receivedValues.resize(self.received.size() * static_cast<std::size_t>(width));
  self.plan->getDistributor().doPostsAndWaits(Teuchos::ArrayView<const double>(self.sentValues),
                                              static_cast<std::size_t>(width),
                                              Teuchos::ArrayView<double>(self.receivedValues));
  const double* in = self.receivedValues.data();
  for (const int point : self.received)
    for (int k = 0; k < width; ++k) values[static_cast<std::size_t>(point) * width + k] = *in++;
}

void GhostExchange::exportAdd(double* values, int width) const {
  if (!implementation_) return;
  Implementation& self = *implementation_;
  self.pack(values, width, self.received, self.receivedValues);
  self.sentValues.resize(self.sent.size() * static_cast<std::size_t>(width));
  self.plan->getDistributor().doReversePostsAndWaits(Teuchos::ArrayView<const double>(self.receivedValues),
                                                     static_cast<std::size_t>(width),
                                                     Teuchos::ArrayView<double>(self.sentValues));
  const double* in = self.sentValues.data();
  for (const int point : self.sent)
    for (int k = 0; k < width; ++k) values[static_cast<std::size_t>(point) * width + k] += *in++;
}

}  // namespace pd

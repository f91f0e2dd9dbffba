#include <mpi.h>

#include <list>
#include <stdexcept>
#include <string>
#include <utility>

#include "explore/ranks.hpp"

namespace bodyline::explore {
namespace {

constexpr int tag = 1;
constexpr int root = 0;

void check(int code) {
  if (code == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(code, text, &length);
  throw std::runtime_error("another rank of the run cannot be reached (" +
                           std::string(text, std::size_t(length)) + "); --resume goes on");
}

class MpiRanks : public Ranks {
 public:
  MpiRanks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  ~MpiRanks() override {
    if (abandoned_) MPI_Abort(MPI_COMM_WORLD, 1);
    for (Sending& sending : sending_) MPI_Wait(&sending.request, MPI_STATUS_IGNORE);
    MPI_Finalize();
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  void abandon() override { abandoned_ = true; }

  Bytes broadcast(Bytes bytes) override {
    unsigned long long count = bytes.size();
    check(MPI_Bcast(&count, 1, MPI_UNSIGNED_LONG_LONG, root, MPI_COMM_WORLD));
    bytes.resize(count);
    check(MPI_Bcast(bytes.data(), int(count), MPI_BYTE, root, MPI_COMM_WORLD));
    return bytes;
  }

  void send(int to, Bytes bytes) override {
    forget_sent();
    Sending& sending = sending_.emplace_back();
    sending.bytes = std::move(bytes);
    check(MPI_Isend(sending.bytes.data(), int(sending.bytes.size()), MPI_BYTE, to, tag,
                    MPI_COMM_WORLD, &sending.request));
  }

  // Never waits: of a rank that is lost half a message may have come, and the rest never will.
  std::optional<RankMessage> receive() override {
    forget_sent();
    if (!arriving_) begin_to_receive();
    if (!arriving_) return std::nullopt;
    int arrived = 0;
    check(MPI_Test(&arrival_, &arrived, MPI_STATUS_IGNORE));
    return arrived ? std::exchange(arriving_, std::nullopt) : std::nullopt;
  }

 private:
  struct Sending {
    Bytes bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  void begin_to_receive() {
    int probed = 0;
    MPI_Status status;
    MPI_Message handle;
    check(MPI_Improbe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &probed, &handle, &status));
    if (!probed) return;
    int count = 0;
    check(MPI_Get_count(&status, MPI_BYTE, &count));
    arriving_ = RankMessage{status.MPI_SOURCE, Bytes(std::size_t(count))};
    check(MPI_Imrecv(arriving_->bytes.data(), count, MPI_BYTE, &handle, &arrival_));
  }

  void forget_sent() {
    for (auto sending = sending_.begin(); sending != sending_.end();) {
      int sent = 0;
      check(MPI_Test(&sending->request, &sent, MPI_STATUS_IGNORE));
      sending = sent ? sending_.erase(sending) : std::next(sending);
    }
  }

  int rank_ = 0, size_ = 1;
  bool abandoned_ = false;
  std::list<Sending> sending_;
  std::optional<RankMessage> arriving_;
  MPI_Request arrival_ = MPI_REQUEST_NULL;  // of it
};

}  // namespace

std::unique_ptr<Ranks> launched_ranks() {
  if (launched_rank() < 0) return nullptr;
  return std::make_unique<MpiRanks>();
}

}  // namespace bodyline::explore

// Ranks by MPI, which is called by the main thread alone.
//
// MPI's own waiting keeps a core busy. So a receiver says that it is ready, and until both are
// there each looks once in a while and sleeps in between.
#include "apps/mpi/job.h"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace sunfleck::engine {
namespace {

constexpr int kReady = 1;  // tags
constexpr int kBytes = 2;

/// MPI counts in int.
constexpr std::size_t kBytesAtOnce = std::size_t{1} << 30U;

void wait_for(int from, int tag) {
    const std::chrono::microseconds longest(1000);
    int there = 0;
    for (std::chrono::microseconds pause(1);; pause = std::min(2 * pause, longest)) {
        MPI_Iprobe(from, tag, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE);
        if (there != 0) return;
        std::this_thread::sleep_for(pause);
    }
}

void send(int to, std::span<const std::byte> bytes) {
    wait_for(to, kReady);
    MPI_Recv(nullptr, 0, MPI_BYTE, to, kReady, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(kBytesAtOnce, bytes.size()))) {
        const auto now = static_cast<int>(std::min(kBytesAtOnce, bytes.size()));
        MPI_Send(bytes.data(), now, MPI_BYTE, to, kBytes, MPI_COMM_WORLD);
    }
}

void receive(int from, std::span<std::byte> bytes) {
    MPI_Send(nullptr, 0, MPI_BYTE, from, kReady, MPI_COMM_WORLD);
    wait_for(from, kBytes);
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(kBytesAtOnce, bytes.size()))) {
        const auto now = static_cast<int>(std::min(kBytesAtOnce, bytes.size()));
        MPI_Recv(bytes.data(), now, MPI_BYTE, from, kBytes, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    }
}

}  // namespace

Job::Job(bool shared) {
    if (!shared) return;
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &ranks_.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks_.size);
    ranks_.send = send;
    ranks_.receive = receive;
}

Job::~Job() {
    int begun = 0;
    MPI_Initialized(&begun);
    if (begun != 0) MPI_Finalize();
}

void Job::abort(int code) const {
    if (!ranks_.is_alone()) MPI_Abort(MPI_COMM_WORLD, code);
}

}  // namespace sunfleck::engine

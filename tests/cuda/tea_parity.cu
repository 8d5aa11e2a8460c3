// AC-T1 and AC-T4 on CUDA; AC-T5: the random words are the same on host and CUDA, bit for bit.
#include "support/backend_option.h"
#include "support/tea_vectors.h"

#include <teapath/core/parallel.h>
#include <teapath/device/cuda_buffer.cuh>
#include <teapath/device/cuda_stream.cuh>
#include <teapath/kernel/sampler.h>

#include <doctest/doctest.h>

#include <atomic>
#include <cstdint>
#include <vector>

namespace tp::test {
namespace {

constexpr uint32_t kCounters = 1u << 24;  // summed up
constexpr uint32_t kCompared = 1u << 16;  // of these, compared word by word

// Counter i; both words vary.
TP_HD TeaBlock counter(uint32_t i) {
    return {i, i * kTeaDelta};
}

// A block's share of the checksum, which is a sum, so that its order does not matter; the factor
// makes a block in another's place count.
TP_HD uint64_t share(uint32_t i, TeaBlock block) {
    return (uint64_t{block.v0} << 32 | block.v1) * (2 * uint64_t{i} + 1);
}

// Counts in `odd` the counters where the code for a fixed number of rounds differs.
__global__ void tea_kernel(TeaKey key, int rounds, unsigned long long* checksum, TeaBlock* words,
                           uint32_t* odd) {
    uint64_t sum = 0;
    for (uint32_t i = blockIdx.x * blockDim.x + threadIdx.x; i < kCounters;
         i += gridDim.x * blockDim.x) {
        const TeaBlock block = tea_encrypt(counter(i), key, rounds);
        if (block != tea_encrypt_unrolled(counter(i), key, rounds)) atomicAdd(odd, 1u);
        sum += share(i, block);
        if (i < kCompared) words[i] = block;
    }
    atomicAdd(checksum, static_cast<unsigned long long>(sum));
}

// What a known answer's inputs give.
struct VectorWords {
    TeaBlock after, unrolled, before;
};
__global__ void vector_kernel(const TeaVector* vectors, uint32_t count, VectorWords* words) {
    const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= count) return;
    const TeaVector& v = vectors[i];
    words[i] = {tea_encrypt(v.block, v.key, v.rounds),
                tea_encrypt_unrolled(v.block, v.key, v.rounds),
                tea_decrypt(v.after, v.key, v.rounds)};
}
__global__ void key_kernel(const TeaKeyVector* vectors, uint32_t count, TeaKey* keys) {
    const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < count) keys[i] = tea_key(vectors[i].device, vectors[i].seed);
}

uint64_t host_checksum(const TeaKey& key, int rounds) {
    std::atomic<uint64_t> checksum = 0;
    parallel_for(kCounters, 1 << 18, [&](int64_t first, int64_t last) {
        uint64_t sum = 0;
        for (auto i = static_cast<uint32_t>(first); i < static_cast<uint32_t>(last); ++i)
            sum += share(i, tea_encrypt(counter(i), key, rounds));
        checksum += sum;
    });
    return checksum;
}

// What the samplers and the key give for case i: fields small, full and run over.
struct SamplerWords {
    TeaKey key;
    TeaBlock block;
    Vec2 numbers;
};
TP_HD SamplerWords sampler_words(uint32_t i, SamplerKind kind) {
    const TeaKey key = tea_key(i % 5, (uint64_t{i % 3} << 40) + i, static_cast<int>(i % 40));
    const uint64_t sample = i % 7 < 5 ? i : (uint64_t{i} << (i % 30));
    const uint32_t dimension = 2 * (i % 11 < 9 ? i % 100 : i);
    const Sampler s = make_sampler(key, i * 977, sample, kind, 6 + static_cast<int>(i % 27));
    return {s.key, sample_block<true>(s, dimension), sample_2d<true>(s, dimension)};
}

__global__ void sampler_kernel(SamplerKind kind, SamplerWords* words) {
    const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < kCompared) words[i] = sampler_words(i, kind);
}

// kernel(inputs, count, outputs) on all of `inputs`.
template <class Output, class Input, class Kernel>
std::vector<Output> on_device(const std::vector<Input>& inputs, Kernel kernel) {
    const Stream stream;
    const auto count = static_cast<uint32_t>(inputs.size());
    DeviceBuffer<Input> device_inputs;
    DeviceBuffer<Output> device_outputs(count);
    device_inputs.upload(inputs.data(), count, stream.get());
    kernel<<<(count + 63) / 64, 64, 0, stream.get()>>>(device_inputs.data(), count,
                                                       device_outputs.data());
    check(cudaGetLastError());
    std::vector<Output> outputs(count);
    device_outputs.download(outputs.data(), stream.get());
    return outputs;
}

bool without_device() {
    if (backend_name() == "cuda") return false;
    MESSAGE("needs a GPU: run with --backend cuda");
    return true;
}

}  // namespace

TEST_CASE("AC-T1, AC-T4: CUDA gives the known words and keys") {
    if (without_device()) return;
    const std::vector<TeaVector> vectors = tea_vectors();
    const auto words = on_device<VectorWords>(vectors, vector_kernel);
    for (size_t i = 0; i < vectors.size(); ++i) {
        CAPTURE(i);
        CHECK(words[i].after == vectors[i].after);
        CHECK(words[i].unrolled == vectors[i].after);
        CHECK(words[i].before == vectors[i].block);
    }
    const std::vector<TeaKeyVector> key_vectors = tea_key_vectors();
    const auto keys = on_device<TeaKey>(key_vectors, key_kernel);
    for (size_t i = 0; i < key_vectors.size(); ++i) {
        CAPTURE(i);
        CHECK(keys[i] == key_vectors[i].key);
    }
}

TEST_CASE("AC-T5: TEA's words are the same on host and CUDA for 1 to 32 rounds") {
    if (without_device()) return;
    const TeaKey key = tea_key(0, 1234567890);
    const Stream stream;
    DeviceBuffer<unsigned long long> checksum(1);
    DeviceBuffer<TeaBlock> device_words(kCompared);
    DeviceBuffer<uint32_t> odd(1);
    odd.clear_to_zero(stream.get());
    std::vector<TeaBlock> words(kCompared);
    for (int rounds = 1; rounds <= 32; ++rounds) {
        CAPTURE(rounds);
        checksum.clear_to_zero(stream.get());
        tea_kernel<<<1024, 256, 0, stream.get()>>>(key, rounds, checksum.data(),
                                                   device_words.data(), odd.data());
        check(cudaGetLastError());
        unsigned long long sum = 0;
        checksum.download(&sum, stream.get());
        CHECK(sum == host_checksum(key, rounds));
        device_words.download(words.data(), stream.get());
        uint32_t other = 0;
        for (uint32_t i = 0; i < kCompared; ++i)
            other += words[i] != tea_encrypt(counter(i), key, rounds);
        CHECK(other == 0);
    }
    uint32_t odd_count = 0;
    odd.download(&odd_count, stream.get());
    CHECK(odd_count == 0);
}

TEST_CASE("AC-T5: keys and the numbers of both samplers are the same on host and CUDA") {
    if (without_device()) return;
    const Stream stream;
    DeviceBuffer<SamplerWords> device_words(kCompared);
    std::vector<SamplerWords> words(kCompared);
    for (const SamplerKind kind : {SamplerKind::Tea, SamplerKind::Sobol}) {
        sampler_kernel<<<kCompared / 256, 256, 0, stream.get()>>>(kind, device_words.data());
        check(cudaGetLastError());
        device_words.download(words.data(), stream.get());
        uint32_t other = 0;
        for (uint32_t i = 0; i < kCompared; ++i) {
            const SamplerWords host = sampler_words(i, kind);
            other += words[i].key != host.key || words[i].block != host.block ||
                     words[i].numbers != host.numbers;
        }
        CHECK(other == 0);
    }
}

}  // namespace tp::test

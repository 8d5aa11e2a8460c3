// Known answers of TEA, for the host and for CUDA. Wheeler's for 32 rounds of zeros; the others
// were made by two independent programs and decrypt back.
#pragma once

#include <teapath/core/tea.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace tp::test {

struct TeaVector {
    TeaKey key;
    TeaBlock block;
    int rounds;
    TeaBlock after;
};

inline constexpr int kVectorRounds[] = {2, 4, 8, 16, 32};

/// Six blocks, each by five numbers of rounds.
inline std::vector<TeaVector> tea_vectors() {
    struct Row {
        TeaKey key;
        TeaBlock block;
        TeaBlock after[5];  // kVectorRounds
    };
    const TeaKey zero, initial = tea_initial_key(),
                       bytes{0x00112233, 0x44556677, 0x8899aabb, 0xccddeeff};
    const uint32_t ones = 0xffffffff;
    const Row rows[] = {
        {zero,
         {0, 0},
         {{0x3e3d2c81, 0x747811b6},
          {0x420a1097, 0xbec5a929},
          {0xed285da1, 0x455b33c1},
          {0xa889f798, 0x182d8083},
          {0x41ea3a0a, 0x94baa940}}},
        {zero,
         {1, 0},
         {{0x3e3d2ba2, 0x74781f87},
          {0x421006e4, 0xc06ba13a},
          {0xa0bc7d76, 0xf13efdd1},
          {0xf4e59373, 0x26ac1d8e},
          {0x9fbae93b, 0x81bbf328}}},
        {initial,
         {0, 0},
         {{0x2993bc2c, 0x7014a5d2},
          {0x5df5f2bf, 0x54ce08ba},
          {0xfbc840dd, 0x18e69c3c},
          {0x741c187d, 0x4d3e2c53},
          {0x83ecc213, 0xa843a7a0}}},
        {initial,
         {12345, 7},
         {{0x29c2ad49, 0x614e5cb7},
          {0x75130546, 0x0a97e66e},
          {0xbe0aecb6, 0x6edf0078},
          {0xa025d928, 0x6f339bae},
          {0xd0291b06, 0xb154e57a}}},
        {bytes,
         {0x01234567, 0x89abcdef},
         {{0xe0091d53, 0x83f90a01},
          {0x125e8983, 0x9ffe6453},
          {0xd6546158, 0xb8f8020c},
          {0x7cf6c003, 0x2c4af316},
          {0x126c6b92, 0xc0653a3e}}},
        {{ones, ones, ones, ones},
         {ones, ones},
         {{0x47732781, 0x5b14ce98},
          {0x89f68060, 0x69167eb6},
          {0xee45114b, 0x1d87a152},
          {0xb06c7941, 0x6d10fe9f},
          {0x319bbefb, 0x016abdb2}}},
    };
    std::vector<TeaVector> vectors;
    for (const Row& row : rows)
        for (int i = 0; i < 5; ++i)
            vectors.push_back({row.key, row.block, kVectorRounds[i], row.after[i]});
    return vectors;
}

struct TeaKeyVector {
    uint32_t device;
    uint64_t seed;
    TeaKey key;
};

/// Keys of devices and seeds by 16 rounds.
inline std::vector<TeaKeyVector> tea_key_vectors() {
    return {{0, 0, {0xa5251860, 0x741c187d, 0xea73e9a7, 0x4d3e2c53}},
            {0, 1234567890, {0x96bc8fc9, 0xe3be30e4, 0x41b81200, 0x5c29c793}},
            {1, 1234567890, {0xd41d8441, 0xf5856747, 0xb4da430a, 0xbfc6e602}},
            {2, 1234567890, {0xa61429a9, 0x97a07b4a, 0x1aadcdd9, 0x4b72647e}},
            {7, 1234567890, {0x74e5b056, 0xfc7e15d5, 0x37f34e33, 0xda6ec407}},
            {0, 1300000000, {0x2389ecb6, 0xb9f72593, 0x8e00e352, 0x7bd815ef}}};
}

/// The listing of Fig. 3 of Sebald's paper as printed: delta is never added.
TP_HD TeaBlock literal_encrypt(TeaBlock block, const TeaKey& key, int rounds) {
    for (int i = 0; i < rounds; ++i)
        tea_cycle(block, key, 0);
    return block;
}

/// Encrypts by the code for a fixed number of rounds, 1 to 32.
template <int... kIndex>
TP_HD TeaBlock tea_encrypt_unrolled(TeaBlock block, const TeaKey& key, int rounds,
                                    std::integer_sequence<int, kIndex...>) {
    TeaBlock after;
    ((rounds == kIndex + 1 ? void(after = tea_encrypt<kIndex + 1>(block, key)) : void()), ...);
    return after;
}
TP_HD TeaBlock tea_encrypt_unrolled(TeaBlock block, const TeaKey& key, int rounds) {
    return tea_encrypt_unrolled(block, key, rounds,
                                std::make_integer_sequence<int, kMaxTeaRounds>{});
}

}  // namespace tp::test

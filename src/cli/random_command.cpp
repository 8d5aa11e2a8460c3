// `teapath random`: the generator itself, for known answers and for batteries of tests.
#include "arguments.h"
#include "command.h"
#include "help_format.h"
#include "random_stream.h"
#include "status.h"

#include <teapath/core/error.h>
#include <teapath/core/tea.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp {
namespace {

constexpr const char* kFooter =
    R"(Words are hexadecimal. The stream is the words of the counters 0, 1, 2, ...
(low half, high half) under the key of seed and device, each word with its least
significant byte first.

Examples:
  teapath random --key a341316c,c8013ea4,ad90777d,7e95761e --block 0,0 --rounds 16
  teapath random --seed 7 --bytes 1000000000 > numbers.bin
  teapath random --seed 7 --bytes 1000000000 | dieharder -a -g 200)";

constexpr int kDefaultRounds = 8;

// The options as typed.
struct Words {
    std::optional<std::string> key, block, rounds, seed, device, bytes;
};

// `N` words in hex, with or without 0x, between commas.
template <size_t N>
std::array<uint32_t, N> parse_words(const char* option, const std::string& text) {
    std::array<uint32_t, N> words{};
    size_t count = 0, start = 0;
    while (start <= text.size()) {
        const size_t end = std::min(text.find(',', start), text.size());
        std::string word = text.substr(start, end - start);
        start = end + 1;
        if (word.starts_with("0x") || word.starts_with("0X")) word.erase(0, 2);
        uint32_t value = 0;
        const char* last = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), last, value, 16);
        if (error != std::errc() || stop != last)
            throw Error(ErrorKind::Usage, fmt::format("'{}' is no 32-bit word in hex", word),
                        option, "give for example a341316c");
        if (count < N) words[count] = value;
        ++count;
    }
    if (count != N)
        throw Error(ErrorKind::Usage,
                    fmt::format("{} word{} given", count, count == 1 ? " is" : "s are"), option,
                    fmt::format("give {} words in hex, with commas between", N));
    return words;
}

int parse_rounds(const Words& words) {
    if (!words.rounds) return kDefaultRounds;
    return static_cast<int>(parse_whole("--rounds", *words.rounds, 1, kMaxTeaRounds));
}

// One block, encrypted.
int print_block(const Words& words) {
    if (!words.key || !words.block)
        throw Error(ErrorKind::Usage, "it belongs to the other of --key and --block",
                    words.key ? "--key" : "--block", "give both");
    if (words.seed || words.device || words.bytes)
        throw Error(ErrorKind::Usage, "that is for the stream of a seed, not for a block",
                    words.bytes  ? "--bytes"
                    : words.seed ? "--seed"
                                 : "--device",
                    "leave out either it or --key and --block");
    const auto k = parse_words<4>("--key", *words.key);
    const auto v = parse_words<2>("--block", *words.block);
    const TeaBlock out = tea_encrypt({v[0], v[1]}, {k[0], k[1], k[2], k[3]}, parse_rounds(words));
    print_result(fmt::format("{:08x} {:08x}\n", out.v0, out.v1));
    return 0;
}

// Writes to stdout; false where the reader has had enough.
bool write_bytes(const void* bytes, size_t size) {
    const bool written = std::fwrite(bytes, 1, size, stdout) == size && std::fflush(stdout) == 0;
    if (!written && errno != EPIPE)
        throw Error(ErrorKind::Output, "cannot write to standard output", "", std::strerror(errno));
    return written;
}

int write_stream(const Words& words) {
    if (!words.bytes)
        throw Error(ErrorKind::Usage, "nothing is asked for", "teapath random",
                    "give --key and --block, or --bytes");
    constexpr int64_t kMost = std::numeric_limits<int64_t>::max();
    int64_t left = parse_whole("--bytes", *words.bytes, 0, kMost);
    const int rounds = parse_rounds(words);
    const int64_t device = words.device ? parse_whole("--device", *words.device, 0, 0xffffffff) : 0;
    const uint64_t seed = words.seed ? parse_seed("--seed", *words.seed) : 0;
    if (isatty(STDOUT_FILENO) != 0)
        throw Error(ErrorKind::Usage, "the stream is bytes, which a terminal cannot show",
                    "--bytes", "write to a file or a program: > FILE, | PROGRAM");
    if (words.seed == "random") print_status(fmt::format("seed {}\n", seed));

    std::signal(SIGPIPE, SIG_IGN);
    const TeaKey key = tea_key(static_cast<uint32_t>(device), seed);
    std::vector<TeaBlock> blocks(size_t{1} << 15);
    const auto chunk = static_cast<int64_t>(blocks.size() * sizeof(TeaBlock));
    for (uint64_t counter = 0; left > 0; counter += blocks.size()) {
        fill_random_stream(blocks, counter, key, rounds);
        const int64_t size = std::min(left, chunk);
        if (!write_bytes(blocks.data(), static_cast<size_t>(size))) return 0;
        left -= size;
    }
    return 0;
}

}  // namespace

Command add_random_command(CLI::App& program) {
    const auto words = std::make_shared<Words>();
    CLI::App* parser = program.add_subcommand("random", "Numbers of the TEA generator");
    parser->formatter(std::make_shared<HelpFormat>("[OPTIONS]"));
    parser->footer(kFooter);
    const auto add = [&](const char* name, std::optional<std::string>& word, const char* value,
                         const char* description) {
        parser
            ->add_option_function<std::string>(
                name, [&word](const std::string& text) { word = text; }, description)
            ->option_text(value);
    };
    add("--key", words->key, "K,K,K,K", "Encrypt a block with this key: four words");
    add("--block", words->block, "V,V", "The block: two words");
    add("--rounds", words->rounds, "N", "Rounds of TEA, 1 to 32 (default 8)");
    add("--bytes", words->bytes, "N", "Write this many bytes of the stream to standard output");
    add("--seed", words->seed, "N|random",
        "Seed of the stream (default 0); random: from the clock");
    add("--device", words->device, "N", "Device of the stream's key (default 0)");
    return {parser, [words] {
                return words->key || words->block ? print_block(*words) : write_stream(*words);
            }};
}

}  // namespace tp

// `teapath random`: the generator itself, for known answers and for batteries of tests.
#include "command.h"

#include <teapath/core/error.h>
#include <teapath/core/tea.h>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace tp {
namespace {

struct RandomOptions {
    std::string key;    // four words in hex, "K,K,K,K"
    std::string block;  // two words in hex
    uint64_t seed = 0;
    uint32_t device = 0;
    int rounds = 8;
    uint64_t bytes = 0;
};

// Words in hex, with or without 0x, between commas.
std::vector<uint32_t> parse_words(const std::string& text, size_t count, const char* option) {
    std::vector<uint32_t> words;
    for (size_t start = 0; start <= text.size();) {
        const size_t end = std::min(text.find(',', start), text.size());
        const std::string word = text.substr(start, end - start);
        size_t used = 0;
        unsigned long value = 0;
        try {
            value = std::stoul(word, &used, 16);
        } catch (const std::exception&) {
            used = 0;
        }
        if (used == 0 || used != word.size() || value > 0xffffffffu || word[0] == '-')
            throw Error(ErrorKind::Usage, fmt::format("'{}' is no 32-bit word in hex", word),
                        option, "for example a341316c");
        words.push_back(static_cast<uint32_t>(value));
        start = end + 1;
    }
    if (words.size() != count)
        throw Error(ErrorKind::Usage, fmt::format("{} words are given", words.size()), option,
                    fmt::format("{} words in hex, with commas between", count));
    return words;
}

int print_block(const RandomOptions& options) {
    const auto k = parse_words(options.key, 4, "--key");
    const auto v = parse_words(options.block, 2, "--block");
    const TeaBlock out = tea_encrypt({v[0], v[1]}, {k[0], k[1], k[2], k[3]}, options.rounds);
    fmt::print("{:08x} {:08x}\n", out.v0, out.v1);
    return 0;
}

// The words of the counters 0, 1, 2, … as they lie in memory, least significant byte first.
int write_stream(const RandomOptions& options) {
    std::signal(SIGPIPE, SIG_IGN);  // a reader that has had enough is no failure
    const TeaKey key = tea_key(options.device, options.seed);
    std::vector<TeaBlock> blocks(size_t{1} << 15);
    uint64_t counter = 0, left = options.bytes;
    while (left > 0) {
        for (TeaBlock& block : blocks) {
            block =
                tea_encrypt({static_cast<uint32_t>(counter), static_cast<uint32_t>(counter >> 32)},
                            key, options.rounds);
            ++counter;
        }
        const size_t size =
            static_cast<size_t>(std::min<uint64_t>(left, blocks.size() * sizeof(TeaBlock)));
        if (std::fwrite(blocks.data(), 1, size, stdout) != size) {
            if (errno == EPIPE) return 0;
            throw Error(ErrorKind::Output, "the stream cannot be written", "standard output",
                        "is the disk full?");
        }
        left -= size;
    }
    if (std::fflush(stdout) != 0 && errno != EPIPE)
        throw Error(ErrorKind::Output, "the stream cannot be written", "standard output",
                    "is the disk full?");
    return 0;
}

int run_random(const RandomOptions& options) {
    if (!options.key.empty() || !options.block.empty()) return print_block(options);
    if (options.bytes == 0)
        throw Error(ErrorKind::Usage, "nothing is asked for", "teapath random",
                    "give --key and --block, or --bytes");
    return write_stream(options);
}

constexpr const char* kFooter = R"(Examples:
  teapath random --key a341316c,c8013ea4,ad90777d,7e95761e --block 0,0 --rounds 16
  teapath random --seed 7 --rounds 8 --bytes 1000000000 | dieharder -a -g 200)";

}  // namespace

Command add_random_command(CLI::App& program) {
    const auto options = std::make_shared<RandomOptions>();
    CLI::App* parser = program.add_subcommand("random", "Numbers of the TEA generator");
    parser->footer(kFooter);
    parser->add_option("--key", options->key, "Encrypt a block with this key: four words in hex")
        ->type_name("K,K,K,K");
    parser->add_option("--block", options->block, "The block: two words in hex")->type_name("V,V");
    parser->add_option("--rounds", options->rounds, "Rounds, 1 to 32 (default 8)")
        ->type_name("N")
        ->check(CLI::Range(1, kMaxTeaRounds));
    parser->add_option("--seed", options->seed, "Seed of the stream's key (default 0)")
        ->type_name("N");
    parser->add_option("--device", options->device, "Device of the stream's key (default 0)")
        ->type_name("N");
    parser
        ->add_option("--bytes", options->bytes, "Write this much of the stream to standard output")
        ->type_name("N");
    return {parser, [options] { return run_random(*options); }};
}

}  // namespace tp

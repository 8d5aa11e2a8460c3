// Checks before an image is decoded: its size, and what stb's decoders do not check themselves:
// damaged files that would crash them or keep them turning for ever.
#pragma once

#include <string>
#include <string_view>

namespace tp {

/// Throws Error(Input) for more than 2^28 pixels. `name` stands for the file.
void check_pixels(int width, int height, const std::string& name);

/// True unless the run-length coding of a Radiance file of that size is broken or cut short: stb
/// would turn for ever on a run of no pixels, which is also what it reads behind the end.
bool has_whole_runs(std::string_view hdr, int width, int height);

/// True unless a Huffman table of a JPEG file has more than 256 codes: stb would write behind it.
/// Other files have none.
bool has_sound_huffman_tables(std::string_view bytes);

/// A Softimage picture, whose decoder crashes on damaged files unless asked for four channels.
bool is_pic(std::string_view bytes);

/// A Photoshop file of 16 bits a channel, which stb's own question does not recognise.
bool is_psd_of_16_bits(std::string_view bytes);

}  // namespace tp

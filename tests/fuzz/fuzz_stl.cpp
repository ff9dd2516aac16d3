// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/mesh_readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    sightline::fuzz::fuzz_stl(data, size);
    return 0;
}

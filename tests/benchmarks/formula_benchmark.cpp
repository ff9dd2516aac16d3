// Evaluating a formula beside the same computation in C++, and compiling one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/formula.h"
#include "core/base/random.h"

namespace sightline {
namespace {

constexpr std::string_view names[] = {"content", "angle", "handed_on", "star", "depth"};
using Values = std::array<double, std::size(names)>;

const char* const texts[] = {
    "content",
    "content + angle * handed_on",
    "min(content, 1) + max(angle, 0) * handed_on",
    "(min(content, 1) + max(angle, 0) * handed_on) * (star ? 1 : 2) + sqrt(depth) / 100",
};

std::vector<Values> inputs() {
    Random random(1);
    std::vector<Values> all(1024);
    for (Values& values : all)
        for (double& value : values) value = random.uniform(0, 2);
    return all;
}

void BM_Formula(benchmark::State& run) {
    const char* const text = texts[run.range(0)];
    const Formula formula(text, names);
    const std::vector<Values> all = inputs();
    std::size_t i = 0;
    for (auto _ : run) benchmark::DoNotOptimize(formula.value(all[i++ % 1024]));
    run.SetLabel(text);
}
BENCHMARK(BM_Formula)->DenseRange(0, std::size(texts) - 1);

/// The third of the texts.
void BM_FormulaInCpp(benchmark::State& run) {
    const std::vector<Values> all = inputs();
    std::size_t i = 0;
    for (auto _ : run) {
        const Values& v = all[i++ % 1024];
        benchmark::DoNotOptimize(std::min(v[0], 1.0) + std::max(v[1], 0.0) * v[2]);
    }
}
BENCHMARK(BM_FormulaInCpp);

void BM_FormulaCompile(benchmark::State& run) {
    const char* const text = texts[std::size(texts) - 1];
    for (auto _ : run) benchmark::DoNotOptimize(Formula(text, names));
    run.SetLabel(text);
}
BENCHMARK(BM_FormulaCompile);

}  // namespace
}  // namespace sightline

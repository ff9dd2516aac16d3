// What the papers leave open in the solidity of a cell (TVCG fig. 5).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/cells/cell_parameters.h"
#include "core/run/problem.h"

namespace sightline {

enum class ViewVector : std::uint8_t { eye, camera };
enum class TransferSign : std::uint8_t { clamp, with_sign, abs };
enum class Penalty : std::uint8_t { multiply, add, none };
enum class SolidityScale : std::uint8_t { max, p95 };

template <>
inline constexpr auto words<ViewVector> = std::to_array<std::string_view>({"eye", "camera"});
template <>
inline constexpr auto words<TransferSign> = std::to_array<std::string_view>({"clamp", "signed", "abs"});
template <>
inline constexpr auto words<Penalty> = std::to_array<std::string_view>({"multiply", "add", "none"});
template <>
inline constexpr auto words<SolidityScale> = std::to_array<std::string_view>({"max", "p95"});

const ParameterRow& view_vector_row();
const ParameterRow& transfer_sign_row();
const ParameterRow& star_shaped_row();
const ParameterRow& penalty_row();
const ParameterRow& penalty_amount_row();
const ParameterRow& solidity_scale_row();
const ParameterRow& own_content_row();

/// All of them and on_reenqueue.
std::vector<const ParameterRow*> plp_parameter_rows();

struct PlpParameters {
    ViewVector view_vector;
    TransferSign transfer_sign;
    bool tests_star_shape;  ///< star_shaped=on, and a penalty to pay
    Penalty penalty;
    double penalty_amount;
    SolidityScale solidity_scale;
    bool own_content;  ///< what the cell itself holds counts for its key too

    explicit PlpParameters(const Parameters& parameters);
};

/// What |A| is divided by: ρ_max or ρ95, never 0.
template <int D>
double solidity_scale(const Problem<D>& problem) {
    const bool p95 = problem.parameters.template choice<SolidityScale>(solidity_scale_row()) == SolidityScale::p95;
    return std::max<double>(1, p95 ? problem.cells->rho_p95 : problem.cells->rho_max);
}

}  // namespace sightline

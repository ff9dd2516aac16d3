// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/plp/plp_parameters.h"

namespace sightline {

const ParameterRow& view_vector_row() {
    static const ParameterRow row =
        choice_row("view_vector", ViewVector::eye, "TVCG fig. 5, line 1",
                   "v: from the eye to the facet's centroid, or the camera's forward direction");
    return row;
}

const ParameterRow& transfer_sign_row() {
    static const ParameterRow row = choice_row("transfer_sign", TransferSign::clamp, "TVCG fig. 5, line 1",
                                               "a negative v · n is set to 0, kept, or made positive");
    return row;
}

const ParameterRow& star_shaped_row() {
    static const ParameterRow row =
        choice_row("star_shaped", Switch::on, "TVCG fig. 5, line 2",
                   "test whether the ray from the eye to a cell's centre crosses the shared facet");
    return row;
}

const ParameterRow& penalty_row() {
    static const ParameterRow row = choice_row("penalty", Penalty::multiply, "TVCG fig. 5, line 3",
                                               "what a cell that fails the star-shape test pays");
    return row;
}

const ParameterRow& penalty_amount_row() {
    static const ParameterRow row = number_row("penalty_amount", "2", 0, 1e6, "[0, 1e6]", "TVCG fig. 5, line 3",
                                               "the factor (multiply) or the amount (add) of the penalty");
    return row;
}

const ParameterRow& solidity_scale_row() {
    static const ParameterRow row =
        choice_row("solidity_scale", SolidityScale::max, "TVCG 3.1",
                   "|A| is divided by the largest |A|, or by the 95th percentile and capped at 1");
    return row;
}

const ParameterRow& own_content_row() {
    static const ParameterRow row =
        choice_row("own_content", Switch::off, "docs/algorithm.md, keys of 0",
                   "what a cell itself holds counts for its own key too, not only for those of the cells behind it");
    return row;
}

std::vector<const ParameterRow*> plp_parameter_rows() {
    return {&view_vector_row(), &transfer_sign_row(),  &on_reenqueue_row(),   &star_shaped_row(),
            &penalty_row(),     &penalty_amount_row(), &solidity_scale_row(), &own_content_row()};
}

PlpParameters::PlpParameters(const Parameters& parameters)
    : view_vector(parameters.choice<ViewVector>(view_vector_row())),
      transfer_sign(parameters.choice<TransferSign>(transfer_sign_row())),
      penalty(parameters.choice<Penalty>(penalty_row())),
      penalty_amount(parameters.number(penalty_amount_row())),
      solidity_scale(parameters.choice<SolidityScale>(solidity_scale_row())),
      own_content(parameters.choice<Switch>(own_content_row()) == Switch::on) {
    tests_star_shape = parameters.choice<Switch>(star_shaped_row()) == Switch::on && penalty != Penalty::none;
}

}  // namespace sightline

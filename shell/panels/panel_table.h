// The rows of each panel.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/panels/panel.h"

namespace sightline {

template <int D>
std::vector<Row> run_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> glossary_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> why_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> code_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> front_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> missed_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> object_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> inversion_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> breakpoint_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> note_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> viewpoint_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> compare_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> trade_off_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> technique_rows(const Workbench<D>& bench);
template <int D>
std::vector<Row> settings_rows(const Workbench<D>& bench);

}  // namespace sightline

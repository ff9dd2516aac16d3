// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/figure.h"

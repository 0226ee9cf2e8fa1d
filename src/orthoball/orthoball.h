// SPDX-License-Identifier: MIT
#pragma once

// Everything, in flow order.
#include "orthoball/error.h"
#include "orthoball/ids.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/version.h"

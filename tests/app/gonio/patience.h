// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

namespace gonio::app::test_support {

/// How long a test waits for background work: enough for a busy machine, ms.
inline constexpr int patienceMilliseconds = 240000;

}  // namespace gonio::app::test_support

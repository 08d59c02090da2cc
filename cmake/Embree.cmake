# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# Embree 4 or 3, the target `embree` (core/geometry/mesh_intersector.h has the differences).
find_package(embree 4 QUIET CONFIG)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED CONFIG)
endif()

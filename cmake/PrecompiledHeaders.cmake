# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# Headers of libraries that most files need, read once a target: reading them was half the time of a build. A set that is too
# large costs more than it saves (GCC maps all of it for every file). Headers of the project stay out, and every file names
# what it uses: with GONIO_PRECOMPILE=OFF everything builds as well.
set(GONIO_CORE_HEADERS
  <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <span> <string> <variant> <vector>
  <Eigen/Core> <glm/glm.hpp>)
set(GONIO_EDITOR_HEADERS ${GONIO_CORE_HEADERS} <nlohmann/json.hpp>
  <QAction> <QBoxLayout> <QCheckBox> <QComboBox> <QFileDialog> <QLabel> <QMenu> <QMouseEvent> <QPainter> <QPointer>
  <QPushButton> <QSettings> <QString> <QTimer> <QToolButton> <QVariant> <QWidget>)

# gonio_precompile(TARGET HEADER ...)
function(gonio_precompile target)
  if(GONIO_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# gonio_precompile_as(TARGET OTHER): takes the headers that OTHER has precompiled with the same flags.
function(gonio_precompile_as target other)
  if(GONIO_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()

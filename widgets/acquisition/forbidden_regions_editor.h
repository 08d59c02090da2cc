// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "core/acquisition/measurable_directions.h"

class QPushButton;
class QTableWidget;

namespace gonio::widgets {

/// Editor of the angle ranges that a rig cannot reach, as rows of degrees: minimum and maximum of the light's polar
/// angle, the viewer's polar angle, and the difference of their azimuths. A cell that is not a number or out of range
/// is reverted; if minimum and maximum are swapped, they are exchanged.
class ForbiddenRegionsEditor : public QWidget {
  Q_OBJECT

 public:
  explicit ForbiddenRegionsEditor(QWidget* parent = nullptr);

  const std::vector<acquisition::ForbiddenRegion>& regions() const { return m_regions; }

 Q_SIGNALS:
  void regionsEdited();

 private:
  void cellChanged(int row, int column);
  void fill();

  QTableWidget* m_table;
  QPushButton *m_add, *m_remove;
  std::vector<acquisition::ForbiddenRegion> m_regions;
};

}  // namespace gonio::widgets

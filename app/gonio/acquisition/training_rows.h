// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <functional>

#include "app/gonio/acquisition/acquisition_training.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;

namespace gonio::app {

/// Rows of a form: the training set, and whether the measured material is left out of it.
class TrainingRows : public QObject {
  Q_OBJECT

 public:
  explicit TrainingRows(QFormLayout& form);

  /// What the library shows at this time.
  void setShownIds(std::function<QStringList()> shownIds) { m_shownIds = std::move(shownIds); }
  TrainingSet training() const;
  /// A training set beside those that are offered.
  void setTraining(const TrainingSet& training);
  bool leavesMeasuredOut() const;
  /// Which material is left out.
  void setMeasuredId(const QString& id);
  void setEnabled(bool enabled);
  void refresh();
  QComboBox& box() const { return *m_box; }

 Q_SIGNALS:
  void edited();

 private:
  /// Items of the box.
  enum Item { measured, nearMeasured, fits, library, shownInLibrary, otherSet, folder };
  void build(QFormLayout& form);
  void activated(int index);
  void askForFolder();

  std::function<QStringList()> m_shownIds;
  TrainingSet m_otherSet;  ///< a folder's
  int m_last = 0;
  QString m_measuredId;
  QComboBox* m_box;
  QCheckBox* m_leaveOut;
  QLabel* m_facts;
};

}  // namespace gonio::app

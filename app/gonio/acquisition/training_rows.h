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

  /// Sets the function that returns the ids currently shown in the library.
  void setShownIds(std::function<QStringList()> shownIds) { m_shownIds = std::move(shownIds); }
  TrainingSet training() const;
  /// Selects a training set that is not among the offered ones.
  void setTraining(const TrainingSet& training);
  bool leavesMeasuredOut() const;
  /// Sets the material to exclude.
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
  TrainingSet m_otherSet;  ///< training set of a folder
  int m_last = 0;
  QString m_measuredId;
  QComboBox* m_box;
  QCheckBox* m_leaveOut;
  QLabel* m_facts;
};

}  // namespace gonio::app

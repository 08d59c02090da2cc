// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/training_rows.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>

#include "app/gonio/acquisition/control_rows.h"

namespace gonio::app {

TrainingRows::TrainingRows(QFormLayout& form)
    : QObject(&form),
      m_box(rowBox(
          tr("Training set: the reconstruction uses the principal components of these materials.\n"
             "Near-measured copies are neural fits of measured materials. They cover more materials than the measured "
             "ones alone; preparing them takes about a minute the first time.\n"
             "\"Materials shown in the library\": the materials that match the current search, including those of an "
             "open library folder."))),
      m_leaveOut(new QCheckBox(tr("Exclude the measured material"))),
      m_facts(new QLabel) {
  build(form);
  connect(m_box, &QComboBox::activated, this, &TrainingRows::activated);
  connect(m_leaveOut, &QCheckBox::toggled, this, &TrainingRows::edited);
}

void TrainingRows::build(QFormLayout& form) {
  form.addRow(rowHeading(tr("Training set")));
  m_box->addItems({tr("Measured materials"), tr("Near-measured copies of MERL"), tr("Published fits"),
                   tr("Measured and near-measured"), tr("Materials shown in the library"), QString(), tr("Folder...")});
  hideItem(*m_box, otherSet, true);
  form.addRow(tr("Materia&ls"), m_box);
  m_leaveOut->setToolTip(
      tr("Excludes the measured material, and files of the same name, from the training set; otherwise the error is "
         "lower than for a new material"));
  m_leaveOut->setChecked(true);
  form.addRow(m_leaveOut);
  m_facts->setForegroundRole(QPalette::PlaceholderText);
  m_facts->setWordWrap(true);
  form.addRow(m_facts);
}

void TrainingRows::activated(int index) {
  if (index == folder) {
    m_box->setCurrentIndex(m_last);
    return askForFolder();
  }
  m_last = index;
  Q_EMIT edited();
}

void TrainingRows::askForFolder() {
  auto* dialog = new QFileDialog(m_box, tr("Training Set Folder"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    setTraining(folderTraining(path));
    Q_EMIT edited();
  });
  dialog->open();
}

void TrainingRows::setTraining(const TrainingSet& training) {
  m_otherSet = training;
  m_box->setItemText(otherSet, training.name);
  hideItem(*m_box, otherSet, false);
  m_box->setCurrentIndex(otherSet);
  m_last = otherSet;
  refresh();
}

TrainingSet TrainingRows::training() const {
  switch (m_box->currentIndex()) {
    case nearMeasured:
      return nearMeasuredTraining();
    case fits:
      return fittedTraining();
    case library:
      return libraryTraining();
    case shownInLibrary:
      return {tr("materials shown in the library"), m_shownIds ? m_shownIds() : QStringList()};
    case otherSet:
      return m_otherSet;
    default:
      return measuredTraining();
  }
}

bool TrainingRows::leavesMeasuredOut() const { return m_leaveOut->isChecked(); }

void TrainingRows::setMeasuredId(const QString& id) {
  m_measuredId = id;
  refresh();
}

void TrainingRows::setEnabled(bool enabled) {
  m_box->setEnabled(enabled);
  m_leaveOut->setEnabled(enabled);
}

void TrainingRows::refresh() {
  const QStringList all = training().ids;
  const int count = int((leavesMeasuredOut() ? without(all, m_measuredId) : all).size());
  QString facts = count < 2 ? tr("Materials: %n; a training set needs at least 2", nullptr, count)
                            : tr("%n materials, one signal for each colour channel", nullptr, count);
  if (const int left = int(all.size()) - count; left > 0) facts += tr("; %n excluded", nullptr, left);
  m_facts->setText(facts);
}

}  // namespace gonio::app

#include "moc_training_rows.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/export/batch_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "app/gonio/document/material_files.h"
#include "app/gonio/export/export_controller.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/icons.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

BatchDialog::BatchDialog(ExportController& controller, QSettings& settings, const QStringList& ids, QWidget* parent)
    : QDialog(parent), m_controller(controller), m_settings(settings), m_ids(ids), m_names(distinctNames(ids)) {
  setWindowTitle(ids.size() == 1 ? tr("Export %1").arg(widgets::titleText(materialName(ids.front())))
                                 : tr("Export %1 Materials").arg(ids.size()));
  build();
  chooseTarget(settings.value(export_settings::target).toString().toStdString());
  m_snr->setValue(settings.value(export_settings::snr, exports::ExportOptions().snr).toDouble());
  const QString beside = controller.document().folder();
  m_folder->setText(beside.isEmpty() ? settings.value(export_settings::folder, QDir::homePath()).toString() : beside);
  connect(m_targets, &QComboBox::currentIndexChanged, this, &BatchDialog::showFiles);
  connect(m_folder, &QLineEdit::textChanged, this, &BatchDialog::showFiles);
  connect(m_replace, &QCheckBox::toggled, this, &BatchDialog::showFiles);
  showFiles();
}

void BatchDialog::build() {
  m_targets = new QComboBox;
  for (const exports::ExportTarget& target : exports::exportTargets())
    m_targets->addItem(widgets::themedIcon(widgets::toQString(target.icon)), widgets::toQString(target.label));
  m_snr = exportSnrField();
  m_folder = new QLineEdit;
  m_folder->setMinimumWidth(fontMetrics().averageCharWidth() * 48);
  m_replace = new QCheckBox(tr("Re&place existing files"));
  for (QLabel** label : {&m_description, &m_files}) {
    *label = exportText();
    (*label)->setMinimumHeight(2 * fontMetrics().lineSpacing());
    (*label)->setMinimumWidth(m_folder->minimumWidth());  // else as tall as for one letter a line
  }
  auto* browse = new QPushButton(tr("&Browse..."));
  browse->setAutoDefault(false);
  connect(browse, &QPushButton::clicked, this, &BatchDialog::browse);
  auto* row = new QHBoxLayout;
  row->addWidget(m_folder, 1);
  row->addWidget(browse);
  auto* folder = new QLabel(tr("&Folder"));
  folder->setBuddy(m_folder);
  auto* form = new QFormLayout;
  form->setVerticalSpacing(fontMetrics().height() / 2);
  form->addRow(tr("&Target"), m_targets);
  form->addRow(QString(), m_description);
  form->addRow(tr("&Match at least"), m_snr);
  form->addRow(folder, row);
  form->addRow(QString(), m_replace);
  form->addRow(tr("Files"), m_files);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  m_export = buttons->addButton(tr("&Export"), QDialogButtonBox::AcceptRole);
  m_export->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &BatchDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addStretch();
  layout->addWidget(buttons);
}

const exports::ExportTarget& BatchDialog::target() const {
  return exports::exportTargets()[std::size_t(m_targets->currentIndex())];
}

void BatchDialog::chooseTarget(std::string_view id) {
  const auto targets = exports::exportTargets();
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (targets[i].id == id) m_targets->setCurrentIndex(int(i));
}

void BatchDialog::browse() {
  auto* dialog = new QFileDialog(this, tr("Export folder"), m_folder->text());
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  widgets::openFileDialog(dialog, [this](const QString& folder) { m_folder->setText(folder); });
}

ExportRequest BatchDialog::request(qsizetype index) const {
  const QString place = m_ids.size() > 1 ? tr("%1 of %2").arg(index + 1).arg(m_ids.size()) : QString();
  return {.target = &target(),
          .options = {.snr = m_snr->value()},
          .name = QDir(m_folder->text()).filePath(m_names[index]),
          .place = place};
}

QStringList BatchDialog::existing() const {
  QStringList names;
  for (qsizetype i = 0; i < m_ids.size(); ++i)
    for (const auto& path : target().paths(request(i).name.toStdString()))
      if (const QFileInfo info(QString::fromStdString(path.string())); info.exists()) names << info.fileName();
  return names;
}

void BatchDialog::showFiles() {
  m_description->setText(widgets::toQString(target().purpose));
  m_description->setToolTip(widgets::toQString(target().limitations));
  const bool hasFolder = QFileInfo(m_folder->text()).isDir();
  const QStringList there = existing();
  const bool blocked = !there.isEmpty() && !m_replace->isChecked();
  m_export->setEnabled(hasFolder && !blocked);
  constexpr int maxNames = 3;
  QStringList names;
  for (qsizetype i = 0; i < std::min(qsizetype(maxNames), m_ids.size()); ++i)
    names << fileNames(target(), request(i).name);
  if (const qsizetype others = m_ids.size() - maxNames; others > 0)
    names << (others == 1 ? tr("and the files of one more material")
                          : tr("and the files of %1 more materials").arg(others));
  QString text = names.join(QStringLiteral(", "));
  if (!hasFolder) text = tr("This folder does not exist. Choose an existing folder.");
  if (blocked) text = tr("Existing files: %1").arg(there.mid(0, maxNames).join(QStringLiteral(", ")));
  if (blocked && there.size() > maxNames) text += tr(" and %1 more").arg(there.size() - maxNames);
  m_files->setText(text);
}

void BatchDialog::accept() {
  if (!m_export->isEnabled()) return;
  m_settings.setValue(export_settings::target, widgets::toQString(target().id));
  m_settings.setValue(export_settings::snr, m_snr->value());
  m_settings.setValue(export_settings::folder, m_folder->text());
  for (qsizetype i = 0; i < m_ids.size(); ++i) m_controller.writeMeasured(m_ids[i], request(i), m_replace->isChecked());
  QDialog::accept();
}

}  // namespace gonio::app

#include "moc_batch_dialog.cpp"

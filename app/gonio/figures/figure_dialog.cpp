// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/figures/figure_dialog.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gonio/figures/figure_file_buttons.h"
#include "app/gonio/figures/figure_materials.h"
#include "app/gonio/figures/figure_numbers.h"
#include "app/gonio/figures/figure_page_settings.h"
#include "app/gonio/figures/figure_view.h"
#include "core/io/json_text.h"

namespace gonio::app {

using figures::FigureDescription;

namespace {

const QString descriptionKey = QStringLiteral("figure/description");
constexpr QSize figureDialogSize(1180, 720);

QGroupBox* groupOf(const QString& title, QWidget* content) {
  auto* box = new QGroupBox(title);
  auto* layout = new QVBoxLayout(box);
  layout->addWidget(content);
  return box;
}

/// Fields of several forms that stand one below the other begin at one place.
void alignFields(const QWidget& tab) {
  std::vector<QWidget*> labels;
  for (const QFormLayout* form : tab.findChildren<QFormLayout*>())
    for (int row = 0; row < form->rowCount(); ++row)
      if (const QLayoutItem* item = form->itemAt(row, QFormLayout::LabelRole)) labels.push_back(item->widget());
  int widest = 0;
  for (const QWidget* label : labels) widest = std::max(widest, label->sizeHint().width());
  for (QWidget* label : labels) label->setMinimumWidth(widest);
}

}  // namespace

FigureDialog::FigureDialog(const Parts& parts, QWidget* parent)
    : QDialog(parent),
      m_parts(parts),
      m_materials(new FigureMaterials({parts.document, parts.library, parts.selectedIds})),
      m_representations(new FigureRepresentations(parts.document)),
      m_numbers(new FigureNumbersList),
      m_pictures(new FigurePictureSettings),
      m_page(new FigurePageSettings),
      m_view(new FigureView(parts.tasks)),
      m_files(new FigureFileButtons(m_view->controller(), parts.exports, parts.tasks)) {
  setWindowTitle(tr("Figure"));
  build();
  connectParts();
  restore();
}

FigureDialog::~FigureDialog() { remember(); }

void FigureDialog::build() {
  resize(figureDialogSize);
  auto* tabs = new QTabWidget;
  tabs->addTab(contentsTab(), tr("Con&tents"));
  tabs->addTab(appearanceTab(), tr("&Appearance"));
  tabs->setFixedWidth(fontMetrics().averageCharWidth() * 66);
  auto* close = new QPushButton(tr("C&lose"));
  close->setAutoDefault(false);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  auto* middle = new QHBoxLayout;
  middle->addWidget(tabs);
  middle->addWidget(m_view, 1);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(m_files, 1);
  bottom->addWidget(close);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(middle, 1);
  layout->addLayout(bottom);
}

QWidget* FigureDialog::contentsTab() {
  auto* tab = new QWidget;
  auto* layout = new QVBoxLayout(tab);
  const std::pair<QString, QWidget*> parts[] = {{tr("Rows: materials"), m_materials},
                                                {tr("Columns: representations"), m_representations},
                                                {tr("Numbers below the images"), m_numbers}};
  for (const auto& [title, part] : parts) layout->addWidget(groupOf(title, part), 1);
  return tab;
}

QWidget* FigureDialog::appearanceTab() {
  auto* tab = new QWidget;
  auto* layout = new QVBoxLayout(tab);
  layout->addWidget(groupOf(tr("Images"), m_pictures));
  layout->addWidget(groupOf(tr("Page"), m_page));
  layout->addStretch();
  alignFields(*tab);
  return tab;
}

void FigureDialog::connectParts() {
  connect(m_materials, &FigureMaterials::changed, this, &FigureDialog::update);
  connect(m_representations, &FigureRepresentations::changed, this, &FigureDialog::update);
  connect(m_numbers, &FigureNumbersList::changed, this, &FigureDialog::update);
  connect(m_pictures, &FigurePictureSettings::changed, this, &FigureDialog::update);
  connect(m_page, &FigurePageSettings::changed, this, &FigureDialog::update);
  connect(m_view, &FigureView::insetDrawn, m_page, &FigurePageSettings::setInset);
  connect(m_files, &FigureFileButtons::opened, this, &FigureDialog::setDescription);
  connect(&m_parts.exports, &FileExports::exported, m_view,
          [this](const QString& path) { m_view->setNotice(tr("Wrote %1").arg(path)); });
  connect(&m_parts.exports, &FileExports::cancelled, m_view,
          [this](const QString& path) { m_view->setNotice(tr("Cancelled: %1 was not written").arg(path)); });
}

FigureDescription FigureDialog::description() const {
  FigureDescription figure;
  figure.materials = m_materials->materials();
  figure.representations = m_representations->representations();
  figure.numbers = m_numbers->numbers();
  figure.pictures = m_pictures->pictures();
  m_page->apply(figure);
  return figure;
}

void FigureDialog::setDescription(const FigureDescription& description) {
  m_materials->setMaterials(description.materials);
  m_representations->setRepresentations(description.representations);
  m_numbers->setNumbers(description.numbers);
  m_pictures->setPictures(description.pictures);
  m_page->setDescription(description);
  update();
}

void FigureDialog::update() {
  const FigureDescription figure = description();
  m_files->setSaving(!figure.materials.empty() && !figure.representations.empty());
  m_view->setDescription(figure);
}

/// Restores the materials of the last figure only if no material is open.
void FigureDialog::restore() {
  FigureDescription figure;
  try {
    figure = figures::figureFromJson(io::parseJson(m_parts.settings.value(descriptionKey).toString().toStdString()));
  } catch (const Error&) {  // no settings, or those of another version
    m_representations->setDefaults();
    figure.representations = m_representations->representations();
  }
  if (const QString open = m_materials->openId(); !open.isEmpty()) figure.materials = {{open.toStdString()}};
  setDescription(figure);
}

void FigureDialog::remember() {
  const FigureDescription figure = description();
  if (figure.materials.empty() || figure.representations.empty()) return;
  m_parts.settings.setValue(descriptionKey, QString::fromStdString(io::jsonText(figures::toJson(figure))));
}

void FigureDialog::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && m_view->controller().isMeasuring()) return m_view->controller().cancel();
  QDialog::keyPressEvent(event);
}

}  // namespace gonio::app

#include "moc_figure_dialog.cpp"

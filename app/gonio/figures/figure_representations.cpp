// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/figures/figure_representations.h"

#include <QMenu>
#include <QVBoxLayout>

#include "app/gonio/document/document.h"
#include "widgets/figures/entry_list.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

using figures::FigureDescription;
using figures::FigureRepresentation;

namespace {

/// The model of the edit shown in the panels; null if there is none.
const models::Model* modelInUse(const Document& document) {
  const auto* edit = document.active<editing::DifferentialEdit>();
  return edit ? edit->model : nullptr;
}

QString budgetAction(const study::Representation& one) {
  return one.budgetText.empty() || one.family == study::RepresentationFamily::fit
             ? QString::fromStdString(one.label)
             : QString::fromStdString(one.budgetText);
}

}  // namespace

FigureRepresentations::FigureRepresentations(const Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_list(new widgets::EntryList(tr("Representation"), true)) {
  m_list->setEmptyText(tr("Add representations: one for each column of the figure."));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_list);
  connectList();
}

void FigureRepresentations::connectList() {
  connect(&m_list->addMenu(), &QMenu::aboutToShow, this, &FigureRepresentations::fillMenu);
  connect(m_list, &widgets::EntryList::removeRequested, this, [this](int row) {
    m_representations.erase(m_representations.begin() + row);
    show();
    Q_EMIT changed();
  });
  connect(m_list, &widgets::EntryList::moveRequested, this, [this](int from, int to) {
    std::swap(m_representations[std::size_t(from)], m_representations[std::size_t(to)]);
    show();
    Q_EMIT changed();
  });
  connect(&m_list->model(), &widgets::EntryListModel::labelEdited, this, [this](int row, const QString& label) {
    m_representations[std::size_t(row)].label = label.toStdString();
    show();
    Q_EMIT changed();
  });
  connect(&m_list->model(), &widgets::EntryListModel::budgetEdited, this,
          [this](int row, int budget) { setBudget(std::size_t(row), budget); });
}

void FigureRepresentations::setRepresentations(std::vector<FigureRepresentation> representations) {
  m_representations = std::move(representations);
  show();
}

void FigureRepresentations::setDefaults() {
  const models::Model* model = modelInUse(m_document);
  setRepresentations({{study::representationById(model ? model->spec().id : "ggx")},
                      {study::representationById("factors-3d", 10)},
                      {study::representationById("code", 256)}});
}

void FigureRepresentations::fillMenu() {
  QMenu& menu = m_list->addMenu();
  menu.clear();
  qDeleteAll(menu.findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly));
  const models::Model* model = modelInUse(m_document);
  QAction* fit =
      menu.addAction(model ? tr("Current Fit (%1)").arg(widgets::toQString(model->spec().name)) : tr("Current Fit"),
                     this, [this, model] {
                       if (model) add(study::representationById(model->spec().id));
                     });
  fit->setEnabled(model != nullptr);
  menu.addSeparator();
  // One submenu per family; representations with a budget have one per id, with the budgets.
  QMenu* part = nullptr;
  QString title;
  for (const study::Representation& one : study::representationsOf({.families = study::familiesWithoutFurtherData()})) {
    const QString wanted = study::needsBudget(one.id) ? QString::fromStdString(one.label)
                                                      : widgets::toQString(study::familyName(one.family));
    if (one.family == study::RepresentationFamily::nonparametric ||
        one.family == study::RepresentationFamily::neural) {  // one alone
      menu.addAction(budgetAction(one), this, [this, one] { add(one); });
      continue;
    }
    if (wanted != title) {
      title = wanted;
      part = menu.addMenu(QString(title).replace(0, 1, title.at(0).toUpper()));
    }
    part->addAction(budgetAction(one), this, [this, one] { add(one); });
  }
}

void FigureRepresentations::add(const study::Representation& representation) {
  m_representations.push_back({representation});
  show();
  m_list->select(int(m_representations.size()) - 1);
  Q_EMIT changed();
}

void FigureRepresentations::setBudget(std::size_t row, int budget) {
  study::Representation& shown = m_representations[row].representation;
  shown = study::representationById(shown.id, budget);
  show();
  Q_EMIT changed();
}

void FigureRepresentations::show() {
  std::vector<widgets::ListEntry> entries;
  for (const FigureRepresentation& one : m_representations) {
    const study::Representation& shown = one.representation;
    widgets::ListEntry entry{.name = QString::fromStdString(shown.label),
                             .toolTip = QString::fromStdString(shown.fullLabel()),
                             .label = QString::fromStdString(one.label),
                             .usualLabel = QString::fromStdString(FigureRepresentation{shown}.shownLabel())};
    if (study::needsBudget(shown.id)) {
      entry.budget = int(shown.budget);
      entry.maxBudget = study::maxBudget(shown.id);
    }
    entries.push_back(std::move(entry));
  }
  m_list->setEntries(std::move(entries), m_representations.size() >= FigureDescription::maxRepresentations);
}

}  // namespace gonio::app

#include "moc_figure_representations.cpp"

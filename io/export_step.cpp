#include "io/export_step.hpp"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <sstream>
#include <stdexcept>

#include "io/export_shell.hpp"

namespace bodyline::io {
namespace {

/// A string as STEP may hold it: printable ASCII without quotes and backslashes.
std::string plain(const std::string& text) {
  std::string result;
  for (char c : text) result += c >= ' ' && c <= '~' && c != '\'' && c != '\\' ? c : '_';
  return result;
}

Handle(TCollection_HAsciiString) to_cad(const std::string& text) {
  return new TCollection_HAsciiString(text.c_str());
}

void name_faces(STEPControl_Writer& writer, const CadShell& cad,
                const std::vector<std::string>& names) {
  const Handle(Transfer_FinderProcess) finder = writer.WS()->TransferWriter()->FinderProcess();
  for (std::size_t f = 0; f < names.size(); ++f) {
    const Handle(StepRepr_RepresentationItem) item =
        STEPConstruct::FindEntity(finder, cad.faces[f]);
    if (item.IsNull()) throw std::runtime_error("OpenCASCADE did not write the face " + names[f]);
    item->SetName(to_cad(plain(names[f])));
  }
}

/// OpenCASCADE numbers the products it writes; this gives the product the name alone.
void name_product(STEPControl_Writer& writer, const std::string& name) {
  const Handle(StepData_StepModel) step = writer.Model();
  for (int k = 1; k <= step->NbEntities(); ++k) {
    const auto product = Handle(StepBasic_Product)::DownCast(step->Value(k));
    if (product.IsNull()) continue;
    product->SetId(to_cad(plain(name)));
    product->SetName(to_cad(plain(name)));
  }
}

std::string write_text(STEPControl_Writer& writer, const std::string& name) {
  const Handle(StepData_StepModel) step = writer.Model();
  APIHeaderSection_MakeHeader header(step);
  header.SetName(to_cad(plain(name)));
  header.SetAuthorValue(1, to_cad(""));
  header.SetOrganizationValue(1, to_cad(""));
  header.SetOriginatingSystem(to_cad("Bodyline"));
  header.Apply(step);
  StepData_StepWriter file(step);
  file.FloatWriter().SetFormat("%.15E");
  file.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ostringstream text;
  if (!file.Print(text)) throw std::runtime_error("OpenCASCADE could not write the STEP file");
  return text.str();
}

}  // namespace

CadFile step_file(const std::vector<model::Surface>& surfaces, const std::string& name) {
  const QuietCad quiet;
  return step_file(make_shell(surfaces), face_names(surfaces), name);
}

CadFile step_file(const CadShell& cad, const std::vector<std::string>& names,
                  const std::string& name) {
  const QuietCad quiet;
  STEPControl_Writer writer;  // registers the settings below
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  Interface_Static::SetIVal("write.step.assembly", 0);  // several shells stay one product
  writer.Model(true);
  if (writer.Transfer(cad.shape, STEPControl_AsIs) != IFSelect_RetDone)
    throw std::runtime_error("OpenCASCADE could not translate the faces to STEP");
  name_faces(writer, cad, names);
  name_product(writer, name);
  return {write_text(writer, name), cad.max_deviation_mm, cad.not_polynomial};
}

}  // namespace bodyline::io

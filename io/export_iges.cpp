#include <IGESBasic_Name.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESData_Protocol.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <Interface_FloatWriter.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeMapper.hxx>
#include <Transfer_FinderProcess.hxx>
#include <sstream>
#include <stdexcept>

#include "io/export_shell.hpp"
#include "io/export_step.hpp"

namespace bodyline::io {
namespace {

constexpr int brep_mode = 1;             // shells and faces rather than loose trimmed surfaces
constexpr std::size_t label_length = 8;  // of the label in an entity's directory entry

Handle(TCollection_HAsciiString) to_cad(const std::string& text) {
  return new TCollection_HAsciiString(text.c_str());
}

void name_faces(IGESControl_Writer& writer, const CadShell& cad,
                const std::vector<std::string>& names) {
  const Handle(Transfer_FinderProcess) finder = writer.TransferProcess();
  for (std::size_t f = 0; f < names.size(); ++f) {
    Handle(IGESData_IGESEntity) entity;
    const Handle(TransferBRep_ShapeMapper) mapper = TransferBRep::ShapeMapper(finder, cad.faces[f]);
    if (!finder->FindTypedTransient(mapper, STANDARD_TYPE(IGESData_IGESEntity), entity))
      throw std::runtime_error("OpenCASCADE did not write the face " + names[f]);
    const Handle(IGESBasic_Name) property = new IGESBasic_Name;
    property->Init(1, to_cad(names[f]));
    entity->AddProperty(property);
    entity->SetLabel(to_cad(names[f].substr(0, label_length)));
    writer.AddEntity(property);
  }
}

std::string write_text(IGESControl_Writer& writer) {
  IGESData_IGESWriter file(writer.Model());
  file.FloatWriter().SetFormat("%.15E");  // OpenCASCADE's own choice loses 5e-7 mm
  file.SendModel(IGESSelect_WorkLibrary::DefineProtocol());
  std::ostringstream text;
  if (!file.Print(text)) throw std::runtime_error("OpenCASCADE could not write the IGES file");
  return text.str();
}

}  // namespace

CadFile iges_file(const std::vector<model::Surface>& surfaces, const std::string& name) {
  const QuietCad quiet;
  return iges_file(make_shell(surfaces), face_names(surfaces), name);
}

CadFile iges_file(const CadShell& cad, const std::vector<std::string>& names,
                  const std::string& name) {
  const QuietCad quiet;
  IGESControl_Writer writer("MM", brep_mode);
  Interface_Static::SetCVal("write.iges.header.product", name.c_str());
  if (!writer.AddShape(cad.shape))
    throw std::runtime_error("OpenCASCADE could not translate the faces to IGES");
  name_faces(writer, cad, names);
  writer.ComputeModel();
  return {write_text(writer), cad.max_deviation_mm, cad.not_polynomial};
}

}  // namespace bodyline::io

// Pinocchio's algorithms in CasADi's symbolic scalar, handed over as one text of serialised CasADi Functions.
// Pinocchio has more joint types than Boost's default lists hold; the same definitions as in its CMake target.
#define BOOST_MPL_CFG_NO_PREPROCESSED_HEADERS
#define BOOST_MPL_LIMIT_LIST_SIZE 30
#define BOOST_MPL_LIMIT_VECTOR_SIZE 30
#define BOOST_FUSION_INVOKE_MAX_ARITY 12

#include <pinocchio/autodiff/casadi.hpp>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>
#include <pinocchio/serialization.hpp>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

using casadi::Function;
using casadi::SX;
using Scalar = casadi::SX;
using Model = pinocchio::ModelTpl<Scalar>;
using Data = pinocchio::DataTpl<Scalar>;
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

namespace {

template <typename Expression>
SX to_casadi(const Eigen::MatrixBase<Expression>& dense) {
  SX out = SX::zeros(dense.rows(), dense.cols());
  for (Eigen::Index i = 0; i < dense.rows(); ++i)
    for (Eigen::Index j = 0; j < dense.cols(); ++j) out(i, j) = dense(i, j);
  return out;
}

Vector to_eigen(const SX& column) {
  Vector out(column.size1());
  for (casadi_int i = 0; i < column.size1(); ++i) out(i) = column(i);
  return out;
}

std::string functions(const std::string& model_text, pinocchio::FrameIndex frame) {
  pinocchio::Model plain;
  plain.loadFromString(model_text);
  const Model model = plain.cast<Scalar>();
  const SX q = SX::sym("q", model.nq), qd = SX::sym("qd", model.nv);
  const SX qdd = SX::sym("qdd", model.nv), tau = SX::sym("tau", model.nv);
  const Vector q_ = to_eigen(q), qd_ = to_eigen(qd), qdd_ = to_eigen(qdd), tau_ = to_eigen(tau);

  Data data(model);
  pinocchio::computeJointJacobians(model, data, q_);
  pinocchio::updateFramePlacements(model, data);
  Data::Matrix6x jacobian = Data::Matrix6x::Zero(6, model.nv);
  pinocchio::getFrameJacobian(model, data, frame, pinocchio::LOCAL_WORLD_ALIGNED, jacobian);
  SX joints;
  for (const auto& placement : data.oMi) joints = SX::horzcat({joints, to_casadi(placement.toHomogeneousMatrix())});

  Data dynamics(model);
  Matrix mass = pinocchio::crba(model, dynamics, q_, pinocchio::Convention::WORLD);
  mass.triangularView<Eigen::StrictlyLower>() = mass.transpose().triangularView<Eigen::StrictlyLower>();
  const SX torque = to_casadi(pinocchio::rnea(model, dynamics, q_, qd_, qdd_));
  const SX acceleration = to_casadi(pinocchio::aba(model, dynamics, q_, qd_, tau_, pinocchio::Convention::WORLD));

  casadi::StringSerializer out;
  out.pack(std::vector<Function>{
      Function("pose", {q}, {to_casadi(data.oMf[frame].toHomogeneousMatrix())}, {"q"}, {"T"}),
      Function("jacobian", {q}, {to_casadi(jacobian)}, {"q"}, {"J"}),
      Function("joints", {q}, {joints}, {"q"}, {"T"}),
      Function("mass_matrix", {q}, {to_casadi(mass)}, {"q"}, {"M"}),
      Function("rnea", {q, qd, qdd}, {torque}, {"q", "qd", "qdd"}, {"tau"}),
      Function("aba", {q, qd, tau}, {acceleration}, {"q", "qd", "tau"}, {"qdd"})});
  return out.encode();
}

}  // namespace

// Returns 0 and the functions, or 1 and the message of an error; the caller frees `text` with manipplan_free.
extern "C" int manipplan_functions(const char* model_text, unsigned long frame, char** text) {
  try {
    *text = strdup(functions(model_text, frame).c_str());
    return 0;
  } catch (const std::exception& error) {
    *text = strdup(error.what());
  } catch (...) {
    *text = strdup("an error of unknown kind");
  }
  return 1;
}

extern "C" void manipplan_free(char* text) { free(text); }

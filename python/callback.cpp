// Objects of Python that outlive the call that has brought them.
#include "python/callback.h"

#include <utility>

namespace sunfleck::python {

void raise_first(std::initializer_list<Raised> all) {
    const py::error_already_set* first = nullptr;
    for (const Raised& raised : all) {
        if (!raised) continue;
        if (first == nullptr)
            first = &*raised;
        else
            PyException_SetContext(first->value().ptr(), raised->value().inc_ref().ptr());
    }
    if (first != nullptr) throw py::error_already_set(*first);
}

Callback::Callback(py::object function) : function_(std::move(function)) {
    if (PyCallable_Check(function_.ptr()) == 0)
        throw py::type_error("reports and logs are functions, not " +
                             std::string(Py_TYPE(function_.ptr())->tp_name));
}

Callback::~Callback() {
    const LockClaim claim;
    if (claim) {
        const py::gil_scoped_acquire lock;
        if (raised_) raised_->discard_as_unraisable(function_);
        function_ = {};
        raised_.reset();
    } else {  // Python ends, and what it holds with it
        function_.release();
        if (raised_) new py::error_already_set(std::move(*raised_));
    }
}

}  // namespace sunfleck::python

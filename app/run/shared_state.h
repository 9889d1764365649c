// State that the parts of one feature share: its window, its tool, and what it draws over the fields.
#pragma once

#include <map>
#include <memory>
#include <typeindex>

namespace whorl::app {

/// One value of each type, made when it is first asked for.
class SharedState {
  public:
    template <class T>
    T& of() {
        std::shared_ptr<void>& value = values_[typeid(T)];
        if (!value) value = std::make_shared<T>();
        return *static_cast<T*>(value.get());
    }

  private:
    std::map<std::type_index, std::shared_ptr<void>> values_;
};

}  // namespace whorl::app

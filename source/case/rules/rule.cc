#include <continua/case/rules/rule.h>

#include <continua/case/rules/feature.h>

namespace Continua
{
template <int dim>
void check_rules(const std::vector<Rule> &of_features,
                 const Case<dim> &input,
                 ParameterSection root)
{
  FeaturesOfCase<dim> features(input, root);
  for (const Rule &rule : of_features)
    for (const std::string &refused : rule.refused)
    {
      const std::optional<EntryPlace> place = features.place(refused);
      if (!place)
        continue;
      for (const std::string &other : rule.with)
        if (features.place(other))
        {
          ParameterSection section = root;
          for (const std::string &name : place->sections)
            section = section.subsection(name);
          section.refuse(place->key, rule.reason, rule.remedy);
        }
    }
}

template void check_rules(const std::vector<Rule> &, const Case<2> &, ParameterSection);
template void check_rules(const std::vector<Rule> &, const Case<3> &, ParameterSection);
} // namespace Continua

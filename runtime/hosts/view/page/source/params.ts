// A field for each parameter of the program, for running it with other values.
import type { Param } from "../protocol";

/** Removes the unit from a setting. */
function bare(value: string): string {
  return value.replace(/\[.*$/, "");
}

export class ParamFields {
  readonly element = document.createElement("div");
  private readonly fields = new Map<Param, HTMLInputElement>();

  constructor(params: readonly Param[], run: () => void) {
    this.element.className = "params";
    this.element.hidden = params.length === 0;
    for (const param of params) {
      const label = document.createElement("label");
      const field = document.createElement("input");
      const unit = document.createElement("span");
      const isTruth = param.unit === "";
      field.type = isTruth ? "checkbox" : "text";
      field.inputMode = "decimal";
      field.autocomplete = "off";
      field.title = `${param.name} was ${param.value} in this run, and is ${param.first} by default`;
      field.onkeydown = (event) => {
        if (event.key === "Enter") run();
      };
      field.oninput = () => this.mark(param, field);
      unit.textContent = isTruth || param.unit === "1" ? "" : param.unit;
      label.append(param.name, field, unit);
      this.fields.set(param, field);
      this.element.append(label);
    }
    this.reset();
  }

  /** Sets all fields to the values of the run. */
  reset(): void {
    for (const [param, field] of this.fields) {
      field.value = bare(param.value);
      field.checked = param.value === "true";
      this.mark(param, field);
    }
  }

  /** Returns the parameters that differ from the run, as NAME=VALUE. */
  changed(): string[] {
    return [...this.fields]
      .filter(([param, field]) => this.of(param, field) !== bare(param.value))
      .map(([param, field]) => `${param.name}=${this.of(param, field)}`);
  }

  private of(param: Param, field: HTMLInputElement): string {
    return param.unit === "" ? String(field.checked) : field.value.replace(/\s/g, "");
  }

  private mark(param: Param, field: HTMLInputElement): void {
    field.parentElement?.classList.toggle("changed", this.of(param, field) !== bare(param.value));
  }
}

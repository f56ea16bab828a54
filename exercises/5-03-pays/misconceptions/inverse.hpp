bool pays(double cBox, double cObj, double p) { return cBox < p * cObj; }

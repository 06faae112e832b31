# A rubber ring spins freely (plane strain). Nothing acts on it: angular momentum and energy must stay what they are,
# for as many turns as one likes. Sums without gradient correction lose it within one turn, and a kernel of the
# present configuration keeps shuffling particles, which viscosity turns into heat.
#
#   lmp -in in.ring
#   lmp -in in.ring -var frame eulerian -var h 1.3 -var label eulerian

variable        frame     index lagrangian   # lagrangian | eulerian
variable        viscosity index correct      # none | monaghan <a1> <a2> | correct | limited <a1> <a2>
variable        h         index 1.0          # smoothing length in particle spacings
variable        options   index ""           # more words for pair_style
variable        wall      index 10           # particles across the wall of the ring
variable        speed     index 50.0         # of the outer rim, m/s
variable        turns     index 3
variable        jitter    index 0.0          # random displacement of the particles, in spacings
variable        seed      index 4711
variable        cfl       index 0.6          # 0.3 in the Eulerian frame
variable        every     index 50           # steps between two lines of the history
variable        out       index output
variable        label     index ring

units           si
dimension       2
atom_style      sph/solid
boundary        f f p
comm_modify     vel yes
newton          off
atom_modify     map array sort 0 0

region          box block -0.06 0.06 -0.06 0.06 -0.0001 0.0001
create_box      1 box

# ---- the ring: radii 30 and 40 mm, cut out of a square lattice; the particles share its area --------------------

variable        R0        equal 30e-3
variable        R1        equal 40e-3
variable        dx        equal (v_R1-v_R0)/${wall}
lattice         custom 1.0 a1 ${dx} 0 0 a2 0 ${dx} 0 a3 0 0 1 basis 0 0 0 origin 0.5 0.5 0
region          outer cylinder z 0 0 ${R1} INF INF units box
region          inner cylinder z 0 0 ${R0} INF INF side out units box
region          ring intersect 2 outer inner
create_atoms    1 region ring
variable        cell      equal PI*(v_R1^2-v_R0^2)/count(all)
set             group all volume ${cell}

# ---- rubber: rho 1010, c0 852 m/s, mu 0.22 rho c0^2 --------------------------------------------------------------

variable        hlen      equal ${h}*v_dx
pair_style      sph/solid ${hlen} frame ${frame} viscosity ${viscosity} ${options}
pair_coeff      * * inline rho0 1010 eos linear 733.15e6 shear 161.29e6 strength elastic
variable        skin      equal 0.3*v_dx
neighbor        ${skin} bin
neigh_modify    every 1 delay 0 check yes

variable        jump      equal ${jitter}*v_dx
if "${jitter} > 0" then "displace_atoms all random ${jump} ${jump} 0 ${seed} units box"

variable        omega     equal ${speed}/v_R1
variable        vx        atom -v_omega*y
variable        vy        atom v_omega*x
velocity        all set v_vx v_vy NULL units box

fix             move all sph/solid
fix             step all sph/solid/dt 10 ${cfl}

# ---- what is measured ------------------------------------------------------------------------------------------

compute         energy all sph/solid/energy
compute         state all sph/solid/atom sxx syy sxy vonmises
variable        spin      atom mass*(x*vy-y*vx)
variable        mr2       atom mass*(x*x+y*y)
variable        mvx       atom mass*vx
variable        mvy       atom mass*vy
compute         sums all reduce sum v_spin v_mr2 v_mvx v_mvy

variable        time      equal time
variable        tend      equal 2*PI*${turns}/v_omega
variable        done      equal 100*time/v_tend
variable        turned    equal time*v_omega/(2*PI)
variable        Lz        equal c_sums[1]
variable        gyration  equal sqrt(c_sums[2]/mass(all))*1e3
variable        px        equal c_sums[3]
variable        py        equal c_sums[4]
variable        total     equal c_energy
variable        kinetic   equal c_energy[1]
variable        elastic   equal c_energy[3]
variable        viscous   equal c_energy[5]

shell           mkdir ${out}
fix             history all print ${every} &
                "${time},${turned},${Lz},${px},${py},${gyration},${kinetic},${elastic},${viscous},${total}" &
                file ${out}/${label}.csv screen no &
                title "t_s,turns,Lz,px,py,gyration_mm,kinetic_J,elastic_J,viscous_J,total_J"
variable        third     equal v_tend/3
dump            shots all custom 1 ${out}/${label}.dump id x y vx vy c_state[*]
dump_modify     shots every/time ${third} first yes sort id format float %.12g time yes &
                colname c_state[1] sxx colname c_state[2] syy colname c_state[3] sxy colname c_state[4] vonmises

thermo_style    custom step time v_done dt v_Lz v_gyration v_kinetic v_elastic v_viscous v_total
thermo          1000
fix             stop all halt 10 v_time >= ${tend} error continue message no
run             100000000

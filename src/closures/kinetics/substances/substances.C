/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "FlatOutput.H"
#include "substances.H"


Foam::cghs::substances::substances
(
    const wordList& names,
    const dictionary& dict,
    const word& thermo
)
:
    PtrList<substance>(names.size()),
    names_(names)
{
    forAll(names, i)
    {
        if (!dict.isDict(names[i]))
        {
            FatalIOErrorInFunction(dict)
                << "There is no dictionary " << names[i]
                << " of the substance of this name" << nl
                << "Give its elements and thermodynamics" << nl
                << exit(FatalIOError);
        }
        set(i, new substance(names[i], dict.subDict(names[i]), thermo));
        straight_ = straight_ && operator[](i).straight();
    }
}


Foam::scalar
Foam::cghs::substances::massOf(const UList<scalar>& n) const
{
    scalar m = 0;
    forAll(*this, k)
    {
        m += n[k]*operator[](k).M();
    }
    return m;
}


Foam::scalar
Foam::cghs::substances::volumeOf(const UList<scalar>& n) const
{
    scalar V = 0;
    forAll(*this, k)
    {
        V += n[k]*operator[](k).M()/operator[](k).rho();
    }
    return V;
}


Foam::scalar Foam::cghs::substances::enthalpyOf
(
    const UList<scalar>& n,
    const scalar T
) const
{
    scalar H = 0;
    forAll(*this, k)
    {
        H += n[k]*operator[](k).h(T);
    }
    return H;
}
